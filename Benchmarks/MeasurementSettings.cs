using BenchmarkDotNet.Columns;
using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Diagnosers;
using BenchmarkDotNet.Jobs;
using BenchmarkDotNet.Loggers;
using Perfolizer.Horology;

namespace Nowpose.Benchmarks;

/// <summary>Settings of all benchmarks. Each method runs in a separate process. All methods together take about a minute.</summary>
static class MeasurementSettings
{
    public static IConfig Create() => ManualConfig.CreateEmpty()
        .AddLogger(ConsoleLogger.Default)
        .AddColumnProvider(DefaultColumnProviders.Instance)
        .AddDiagnoser(MemoryDiagnoser.Default)
        // The build includes all referenced projects, such as the command line, and takes minutes on a busy machine.
        .WithBuildTimeout(TimeSpan.FromMinutes(10))
        .AddJob(Job.Default
            .WithIterationTime(TimeInterval.FromMilliseconds(100))
            .WithWarmupCount(8)
            .WithIterationCount(20));
}
