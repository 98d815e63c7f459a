using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Nowpose.NativeWebSocket")]
[assembly: InternalsVisibleTo("Nowpose.Cli")]

// Nowpose.OpenXR converts the runtime's times and reports the properties of the display.
[assembly: InternalsVisibleTo("Nowpose.OpenXR")]

// The gateway writes session files with the same classes as the headset.
[assembly: InternalsVisibleTo("Nowpose.Gateway")]

// Nowpose.Tests tests internals, such as the distinction between an overtaken sample and a clock that went back.
[assembly: InternalsVisibleTo("Nowpose.Tests")]

// These test assemblies exist only in this package's repository. They test internals under simulated conditions.
[assembly: InternalsVisibleTo("Nowpose.Headless.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]

// This assembly exists only in this package's repository. It is a simulated robot controller that computes the pose of its tool.
[assembly: InternalsVisibleTo("Nowpose.RtdeServer")]

// This assembly exists only in this package's repository. Its benchmarks use the same internals as the tests.
[assembly: InternalsVisibleTo("Nowpose.Benchmarks")]

// The package's other assemblies, tools and tests, which also use internals.
[assembly: InternalsVisibleTo("Nowpose.Unity")]
[assembly: InternalsVisibleTo("Nowpose.Editor")]
[assembly: InternalsVisibleTo("Nowpose.ArFoundation")]
[assembly: InternalsVisibleTo("Nowpose.Prefabs")]
[assembly: InternalsVisibleTo("Nowpose.Mono.Aot")]
[assembly: InternalsVisibleTo("Nowpose.Mono.Cost")]
[assembly: InternalsVisibleTo("Nowpose.NativeWebSocket.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Peer")]
[assembly: InternalsVisibleTo("Nowpose.Vision")]
