using NUnit.Framework;
using Nowpose.Cli.Headset;
using Nowpose.Session;

namespace Nowpose.Headless.Tests.Cli.Headset;

public class PoseCountTests
{
    readonly PoseCount _poses = new();
    int _frame;

    void Play(double seconds, PoseState state)
    {
        for (var end = _frame + (int)(seconds * 60); _frame < end; _frame++) _poses.Add(TimeSpan.FromSeconds(_frame / 60.0), state);
    }

    [Test]
    public void Result_TimesNotCurrent_SumsThemFromTheFirstCurrentFrame()
    {
        Play(2, PoseState.Unsynchronised);
        Play(3, PoseState.Current);
        Play(0.5, PoseState.Held);
        Play(3, PoseState.Current);
        Play(1, PoseState.Incomplete);
        Play(0.5, PoseState.Held);
        Play(2, PoseState.Current);

        var result = _poses.Result("current");

        Assert.That(result.CurrentAfterS, Is.EqualTo(2).Within(1e-6));
        Assert.That(result.NotCurrentS, Is.EqualTo(2).Within(1e-6));
        Assert.That(result.LongestNotCurrentS, Is.EqualTo(1.5).Within(1e-6));
        Assert.That(result.CurrentShare, Is.EqualTo(0.8).Within(1e-6));
    }
}
