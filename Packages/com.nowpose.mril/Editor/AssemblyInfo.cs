using System.Runtime.CompilerServices;

// Nowpose.Tests tests the classes of this assembly that need no Unity editor.
[assembly: InternalsVisibleTo("Nowpose.Tests")]

// These test assemblies exist only in the repository. They test windows, inspectors and imports with a stand-in for the Unity editor.
[assembly: InternalsVisibleTo("Nowpose.Headless.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]

// The command line tool uses the same list of requirements and the same merge of manifests.
[assembly: InternalsVisibleTo("Nowpose.Cli")]
