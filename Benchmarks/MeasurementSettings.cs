using BenchmarkDotNet.Columns;
using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Diagnosers;
using BenchmarkDotNet.Jobs;
using BenchmarkDotNet.Loggers;
using Perfolizer.Horology;

namespace Nowpose.Benchmarks;

/// <summary>Settings of all measurements: each method in a separate process, all in about a minute.</summary>
static class MeasurementSettings
{
    public static IConfig Create() => ManualConfig.CreateEmpty()
        .AddLogger(ConsoleLogger.Default)
        .AddColumnProvider(DefaultColumnProviders.Instance)
        .AddDiagnoser(MemoryDiagnoser.Default)
        // It builds all referenced projects including the command line, which takes minutes on a busy machine.
        .WithBuildTimeout(TimeSpan.FromMinutes(10))
        .AddJob(Job.Default
            .WithIterationTime(TimeInterval.FromMilliseconds(100))
            .WithWarmupCount(8)
            .WithIterationCount(20));
}
