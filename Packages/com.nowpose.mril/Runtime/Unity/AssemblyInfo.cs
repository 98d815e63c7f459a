using System.Runtime.CompilerServices;

// The URDF importer builds prefabs with the same internal classes with which a rig builds its robot at run time.
[assembly: InternalsVisibleTo("Nowpose.Editor")]

// The assemblies for optional packages share internal helpers, for example to log and to find a session.
[assembly: InternalsVisibleTo("Nowpose.ArFoundation")]
[assembly: InternalsVisibleTo("Nowpose.OpenXR")]
[assembly: InternalsVisibleTo("Nowpose.OpenXR.Anchoring")]
[assembly: InternalsVisibleTo("Nowpose.MRTK3")]

// The tool that builds the prefabs uses the dimensions of the status panel.
[assembly: InternalsVisibleTo("Nowpose.Prefabs")]

// These tests cover the classes of this assembly that need no scene.
[assembly: InternalsVisibleTo("Nowpose.Tests")]
