using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Nowpose.NativeWebSocket")]
[assembly: InternalsVisibleTo("Nowpose.Cli")]

// It converts the runtime's times and reports what the display does.
[assembly: InternalsVisibleTo("Nowpose.OpenXR")]

// It writes session files by the same classes.
[assembly: InternalsVisibleTo("Nowpose.Gateway")]

// What tells an overtaken sample from a clock that went back has laws of its own, which a whole session would blur.
[assembly: InternalsVisibleTo("Nowpose.Tests")]

// Only this package's repository has it: the same in the studies' simulated conditions.
[assembly: InternalsVisibleTo("Nowpose.Headless.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Unity.Tests")]

// Only this package's repository has it: its controller tells where its tool is.
[assembly: InternalsVisibleTo("Nowpose.RtdeServer")]

// Only this package's repository has it: it emulates links by the same profiles as the tests.
[assembly: InternalsVisibleTo("Nowpose.Benchmarks")]

// The package's other assemblies and tools share what is not an interface for users.
[assembly: InternalsVisibleTo("Nowpose.Unity")]
[assembly: InternalsVisibleTo("Nowpose.Editor")]
[assembly: InternalsVisibleTo("Nowpose.ArFoundation")]
[assembly: InternalsVisibleTo("Nowpose.OpenXR.Anchoring")]
[assembly: InternalsVisibleTo("Nowpose.MRTK3")]
[assembly: InternalsVisibleTo("Nowpose.Unity.NativeWebSocket")]
[assembly: InternalsVisibleTo("Nowpose.Prefabs")]
[assembly: InternalsVisibleTo("Nowpose.Studies")]
[assembly: InternalsVisibleTo("Nowpose.Mono.Aot")]
[assembly: InternalsVisibleTo("Nowpose.Mono.Cost")]
[assembly: InternalsVisibleTo("Nowpose.NativeWebSocket.Tests")]
[assembly: InternalsVisibleTo("Nowpose.Peer")]
[assembly: InternalsVisibleTo("Nowpose.UnityPlayer")]
[assembly: InternalsVisibleTo("Nowpose.Vision")]
