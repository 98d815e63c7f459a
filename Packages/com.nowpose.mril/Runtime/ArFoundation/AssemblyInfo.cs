using System.Runtime.CompilerServices;

// That assembly uses this assembly's internal OriginManager and MarkerRecords.
[assembly: InternalsVisibleTo("Nowpose.OpenXR.Anchoring")]

// The test assembly exists only in the repository, not in the package.
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]
