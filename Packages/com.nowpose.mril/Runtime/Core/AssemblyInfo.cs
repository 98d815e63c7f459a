using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Nowpose.NativeWebSocket")]
