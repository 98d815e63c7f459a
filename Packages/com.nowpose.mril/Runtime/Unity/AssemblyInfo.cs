using System.Runtime.CompilerServices;

// The importer builds its prefabs as the rig builds its robot at run time.
[assembly: InternalsVisibleTo("Nowpose.Editor")]
