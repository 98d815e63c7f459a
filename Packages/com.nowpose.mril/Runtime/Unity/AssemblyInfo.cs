using System.Runtime.CompilerServices;

// The importer builds its prefabs as the rig builds its robot at run time.
[assembly: InternalsVisibleTo("Nowpose.Editor")]

// The package's components for optional packages say what is wrong in the same way, and find their session likewise.
[assembly: InternalsVisibleTo("Nowpose.ArFoundation")]
[assembly: InternalsVisibleTo("Nowpose.OpenXR")]
[assembly: InternalsVisibleTo("Nowpose.OpenXR.Anchoring")]

// What a panel says is decided in plain classes; their tests need no scene.
[assembly: InternalsVisibleTo("Nowpose.Tests")]
