// What a TSX page may not write.
import 'synthetica/element';

export const wrong = <synthetica-linkage type="3RPS" interaction="some" />;
