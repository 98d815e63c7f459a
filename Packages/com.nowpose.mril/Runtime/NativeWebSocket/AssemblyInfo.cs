using System.Runtime.CompilerServices;

// It chooses between the links.
[assembly: InternalsVisibleTo("Nowpose.Unity")]

// Only this package's repository has them.
[assembly: InternalsVisibleTo("Nowpose.NativeWebSocket.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]
