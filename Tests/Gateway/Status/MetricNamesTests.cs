using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Compares the names of the metrics with the manual.</summary>
public class MetricNamesTests
{
    static readonly string[] Metrics =
    [
        .. RepositoryFiles.Under("Gateway/Status/Prometheus", ".cs").Select(RepositoryFiles.Read)
            .SelectMany(source => Regex.Matches(source, "\"((?:nowpose|process)_\\w+)\"")).Select(match => match.Groups[1].Value),
    ];

    static readonly string Page = RepositoryFiles.Read(RepositoryFiles.Package + "/Documentation~/gateway-reference.md");

    // The first column of the table of subjects.
    static readonly string[] Beginnings =
    [
        .. Page.Split('\n').SkipWhile(line => line != "| Beginning | Subject |").Skip(2).TakeWhile(line => line.StartsWith('|'))
            .SelectMany(row => Regex.Matches(row.Split('|')[1], "`(\\w+)`")).Select(match => match.Groups[1].Value),
    ];

    [Test]
    public void Metrics_InTheSource_HaveASubjectInTheManual()
    {
        Assert.That(Metrics, Has.Length.GreaterThan(50).And.Unique);
        Assert.That(
            Metrics.Where(metric => !Beginnings.Any(begin => IsOf(metric, begin))), Is.Empty,
            "add the beginning of these names to the table of metrics in gateway-reference.md, or use one of those in the table");
    }

    [Test]
    public void Manual_NamesOfMetrics_Exist()
    {
        var named = Regex.Matches(Page, @"`(nowpose_\w+?)(?:\{[\w,]+\})?`").Select(match => match.Groups[1].Value).Except(["nowpose_"]);

        Assert.That(Beginnings.Where(begin => !Metrics.Any(metric => IsOf(metric, begin))), Is.Empty, "no metric begins like this");
        Assert.That(named.Except(Metrics).Except(Beginnings), Is.Empty, "gateway-reference.md names metrics that do not exist");
    }

    // A beginning without an underscore at its end is a whole name.
    static bool IsOf(string metric, string begin) => begin.EndsWith('_') ? metric.StartsWith(begin, StringComparison.Ordinal) : metric == begin;
}
