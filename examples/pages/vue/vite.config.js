import vue from '@vitejs/plugin-vue';

const isElement = (tag) => tag === 'synthetica-linkage';

export default { plugins: [vue({ template: { compilerOptions: { isCustomElement: isElement } } })] };
