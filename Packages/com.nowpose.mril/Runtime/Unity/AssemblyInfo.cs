using System.Runtime.CompilerServices;

// The importer builds its prefabs as the rig builds its robot at run time.
[assembly: InternalsVisibleTo("Nowpose.Editor")]

// What a panel says is decided in plain classes; their tests need no scene.
[assembly: InternalsVisibleTo("Nowpose.Tests")]
