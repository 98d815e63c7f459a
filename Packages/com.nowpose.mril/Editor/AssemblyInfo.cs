using System.Runtime.CompilerServices;

// Decisions are in plain classes, so that their tests run without an open editor.
[assembly: InternalsVisibleTo("Nowpose.Tests")]

// These assemblies exist only in this package's repository: tests of windows, inspectors and imports on a stub of the editor.
[assembly: InternalsVisibleTo("Nowpose.Headless.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]

// The repository's command line prepares projects with the same requirements and the same merge.
[assembly: InternalsVisibleTo("Nowpose.Cli")]
