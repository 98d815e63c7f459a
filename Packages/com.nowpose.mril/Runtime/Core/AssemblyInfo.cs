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

// Only this package's repository has it: it emulates links by the same profiles as the tests.
[assembly: InternalsVisibleTo("Nowpose.Benchmarks")]
