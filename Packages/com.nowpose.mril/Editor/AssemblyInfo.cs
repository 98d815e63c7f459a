using System.Runtime.CompilerServices;

// Tests the plain classes of this assembly without a Unity editor.
[assembly: InternalsVisibleTo("Nowpose.Tests")]

// These test assemblies exist only in the repository. They test windows, inspectors and imports with a stand-in for the Unity editor.
[assembly: InternalsVisibleTo("Nowpose.Headless.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]

// The command line tool prepares projects with the same requirements and the same merge of manifests.
[assembly: InternalsVisibleTo("Nowpose.Cli")]
