using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate.Pictures;

/// <summary>
/// Runs the fixtures of this namespace, which read pictures, one after the other on a single thread, so that they use the same two workers. The start
/// of a worker takes the processor time of five pictures, and concurrent fixtures would start workers of their own.
/// </summary>
[SetUpFixture]
[SingleThreaded]
[Parallelizable(ParallelScope.Self)]
public sealed class OneAtATime;
