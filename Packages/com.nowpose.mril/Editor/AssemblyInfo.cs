using System.Runtime.CompilerServices;

// What is decided without a window is in plain classes; their tests need no editor open.
[assembly: InternalsVisibleTo("Nowpose.Tests")]

// Only this package's repository has it: the tests of windows, inspectors and imports, on a stand-in for the editor.
[assembly: InternalsVisibleTo("Nowpose.Headless.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]

// The command line of the repository prepares projects by the same table and the same merge.
[assembly: InternalsVisibleTo("Nowpose.Cli")]
