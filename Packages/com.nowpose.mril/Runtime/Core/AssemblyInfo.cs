using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Nowpose.NativeWebSocket")]
[assembly: InternalsVisibleTo("Nowpose.Cli")]
