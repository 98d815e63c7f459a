using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Plants;
using Nowpose.Motion;
using Nowpose.Simulation.Work;

namespace Nowpose.Headless.Tests.Gateway.Faults;

/// <summary>Creates a simulated cell with a moving youBot.</summary>
static class FaultCell
{
    public static SimulatedCell In(MessageHub hub, IControlClock clock)
    {
        var cell = new SimulatedCell(
            new CellMotion(new PickAndPlaceMotion(RobotFiles.Load("youbot"))), clock,
            new CellTiming(TimeSpan.FromMilliseconds(50), TimeSpan.FromMilliseconds(10), TimeSpan.FromMilliseconds(20)), seed: 1);
        cell.PublishInto(hub);
        return cell;
    }
}
