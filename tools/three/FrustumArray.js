/** What several cameras in one see: there is one camera at a time. */
export class FrustumArray {
  setFromArrayCamera() {
    throw new Error('A camera is made of several, which tools/three leaves out.');
  }
}
