using System.Runtime.CompilerServices;

// Nowpose.Unity selects the WebSocket implementation.
[assembly: InternalsVisibleTo("Nowpose.Unity")]

// The test assembly exists only in the repository, not in the package.
[assembly: InternalsVisibleTo("Nowpose.NativeWebSocket.Tests")]
