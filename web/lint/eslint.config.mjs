// Rules for web/client/src. packaging/lint.py copies this file beside its packages, and the page into client/.
import eslint from "@eslint/js";
import { defineConfig } from "eslint/config";
import typescript from "typescript-eslint";

// Not the page's own TypeScript 7, which typescript-eslint cannot read yet; tsc of that version checks the types.
const off = (...rules) => Object.fromEntries(rules.map((rule) => [`@typescript-eslint/${rule}`, "off"]));

export default defineConfig(
  { ignores: ["*.mjs"] },
  eslint.configs.recommended,
  typescript.configs.recommendedTypeChecked,
  {
    languageOptions: { parserOptions: { project: "client/tsconfig.json", tsconfigRootDir: import.meta.dirname } },
    linterOptions: { reportUnusedDisableDirectives: "error" },
    rules: {
      "preserve-caught-error": "error",
      // `a ? b() : c()` is a statement here.
      "@typescript-eslint/no-unused-expressions": ["error", { allowTernary: true }],
      // `const { format, ...rest } = job` leaves a member out.
      "@typescript-eslint/no-unused-vars": ["error", { ignoreRestSiblings: true }],
      // Answers in JSON, and all of three.js, which comes without its types.
      ...off("no-unsafe-argument", "no-unsafe-assignment", "no-unsafe-call", "no-unsafe-member-access",
        "no-unsafe-return"),
    },
  },
  // They draw by three.js.
  { files: ["client/src/playback.ts", "client/src/scene.ts"], rules: off("no-explicit-any") },
);
