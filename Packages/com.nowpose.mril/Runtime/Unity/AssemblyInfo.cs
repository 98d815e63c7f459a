using System.Runtime.CompilerServices;

// The importer builds its prefabs in the same way as the rig builds its robot at run time.
[assembly: InternalsVisibleTo("Nowpose.Editor")]

// The assemblies for optional packages use the same internal helpers for logging and for finding a session.
[assembly: InternalsVisibleTo("Nowpose.ArFoundation")]
[assembly: InternalsVisibleTo("Nowpose.OpenXR")]
[assembly: InternalsVisibleTo("Nowpose.OpenXR.Anchoring")]
// Its components log and find their session in the same way.
[assembly: InternalsVisibleTo("Nowpose.MRTK3")]

// Prefabs use the panel's dimensions.
[assembly: InternalsVisibleTo("Nowpose.Prefabs")]

// Plain classes decide the texts of a panel; their tests need no scene.
[assembly: InternalsVisibleTo("Nowpose.Tests")]
