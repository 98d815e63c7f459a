using System.Runtime.CompilerServices;

// Microsoft's markers and its anchor store work on the managers that this assembly finds.
[assembly: InternalsVisibleTo("Nowpose.OpenXR.Anchoring")]

// Only this package's repository has it.
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]
