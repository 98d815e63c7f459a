using Nowpose.Frames;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Prediction;

[NonParallelizable] // measures allocations
public class FrameTreeAllocationTests
{
    const int Objects = 50;

    [Test]
    public void AddAndEvaluate_ManyObjects_AllocateNothing()
    {
        var tree = new FrameTree(() => new BodyPredictor("linear", new PredictionLimits()));
        var names = Enumerable.Range(0, Objects).Select(i => "box" + i).ToArray();
        Play(0, 50);

        var before = GC.GetAllocatedBytesForCurrentThread();
        Play(50, 200);

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
        Assert.That(tree[0].State, Is.EqualTo(FrameState.Current));

        void Play(int from, int to)
        {
            for (var k = from; k < to; k++)
            {
                for (var i = 0; i < Objects; i++)
                    tree.Add(new FrameTransform(ControlTime.FromSeconds(1000 + 0.02 * k), i % 5 == 0 ? FrameParents.World : names[i - 1], names[i],
                        Math.Sin(0.1 * k), i, 0, 0, 0, 0, 1), isStationary: false);
                tree.Evaluate(ControlTime.FromSeconds(1000.1 + 0.02 * k));
            }
        }
    }
}
