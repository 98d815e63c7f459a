using System.Runtime.CompilerServices;

// Microsoft's markers and its anchor store use the managers that this assembly finds.
[assembly: InternalsVisibleTo("Nowpose.OpenXR.Anchoring")]

// This assembly exists only in this package's repository.
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]
