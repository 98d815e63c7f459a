using System.Text.Json;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

/// <summary>Tests the totals of the errors of a session whose joints have different units.</summary>
public class SessionTotalsTests : SessionReplayFixture
{
    [Test]
    public async Task Json_SessionWithRadiansAndMetres_HasATotalForEachUnit()
    {
        VirtualRecording.To(_path, seconds: 8);

        var run = await Run("replay", _path, "--json");

        using var json = JsonDocument.Parse(run.Output);
        var totals = json.RootElement.GetProperty("totals").EnumerateArray().ToDictionary(total => total.GetProperty("unit").GetString());
        var axes = json.RootElement.GetProperty("axes").EnumerateArray().ToLookup(axis => axis.GetProperty("unit").GetString());
        Assert.That(totals.Keys, Is.EquivalentTo(new[] { "rad", "m" }));
        Assert.That((axes["rad"].Count(), axes["m"].Count()), Is.EqualTo((5, 2)));
        foreach (var (unit, total) in totals)
            foreach (var key in new[] { "rms_hold", "rms" })
            {
                var sum = axes[unit].Sum(axis => Math.Pow(axis.GetProperty(key).GetDouble(), 2));
                Assert.That(total.GetProperty(key).GetDouble(), Is.EqualTo(Math.Sqrt(sum)).Within(1e-12), $"{key}, {unit}");
            }
    }

    [Test]
    public async Task Table_SessionWithRadiansAndMetres_HasATotalForEachUnit()
    {
        VirtualRecording.To(_path, seconds: 8);

        var run = await Run("replay", _path);

        foreach (var row in new[] { "arm_joint_1, rad", "gripper_finger_joint_l, m", "all, rad", "all, m", ReplayTexts.AllUnits })
            Assert.That(run.Output, Does.Contain($"│ {row} "));
        Assert.That(run.Output, Does.Not.Contain(ReplayTexts.Units));
    }
}
