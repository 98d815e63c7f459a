using System.Runtime.CompilerServices;

// Nowpose.Unity selects the WebSocket implementation.
[assembly: InternalsVisibleTo("Nowpose.Unity")]

// The test assemblies exist only in the repository, not in the package.
[assembly: InternalsVisibleTo("Nowpose.NativeWebSocket.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]
