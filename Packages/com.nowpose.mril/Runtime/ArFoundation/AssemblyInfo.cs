using System.Runtime.CompilerServices;

// Nowpose.OpenXR.Anchoring uses the internal classes OriginManager and MarkerRecords.
[assembly: InternalsVisibleTo("Nowpose.OpenXR.Anchoring")]

// The test assembly exists only in the repository, not in the package.
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]
