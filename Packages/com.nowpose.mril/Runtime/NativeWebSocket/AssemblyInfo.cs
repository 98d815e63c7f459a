using System.Runtime.CompilerServices;

// This assembly chooses between the links.
[assembly: InternalsVisibleTo("Nowpose.Unity")]

// These exist only in this package's repository.
[assembly: InternalsVisibleTo("Nowpose.NativeWebSocket.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]
