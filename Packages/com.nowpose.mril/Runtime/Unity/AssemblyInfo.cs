using System.Runtime.CompilerServices;

// The importer builds its prefabs as the rig builds its robot at run time.
[assembly: InternalsVisibleTo("Nowpose.Editor")]

// The package's components for optional packages say what is wrong in the same way, and find their session likewise.
[assembly: InternalsVisibleTo("Nowpose.ArFoundation")]
[assembly: InternalsVisibleTo("Nowpose.OpenXR")]
[assembly: InternalsVisibleTo("Nowpose.OpenXR.Anchoring")]
// Its components log and look for their session as those of this assembly do.
[assembly: InternalsVisibleTo("Nowpose.MRTK3")]

// Prefabs are built to the panel's measures.
[assembly: InternalsVisibleTo("Nowpose.Prefabs")]

// What a panel says is decided in plain classes; their tests need no scene.
[assembly: InternalsVisibleTo("Nowpose.Tests")]
