using NUnit.Framework;
using Nowpose.Gateway.Status.Events;
using Nowpose.Headless.Tests.Gateway.Clock;

namespace Nowpose.Headless.Tests.Gateway.Status;

public class ClockStepsTests
{
    [Test]
    public void Look_ControlClockStepped_AddsOneEventPerStep()
    {
        var plant = new VirtualPlant();
        var plc = plant.Add("plc", 1000, 20);
        var events = new EventList(new SteppedTime(), (_, _) => { });
        var steps = new ClockSteps(plant.Clocks, events);
        void Run(double seconds)
        {
            for (var i = 0; i < seconds * 5; i++)
            {
                plant.Run(TimeSpan.FromSeconds(0.2));
                steps.Look();
            }
        }

        Run(60);
        Assert.That(events.Read(), Is.Empty);

        plc.Step(TimeSpan.FromSeconds(-1));
        Run(20);

        var one = events.Read().Single();
        Assert.That((one.Condition.Kind, one.Condition.Which, one.Condition.What), Is.EqualTo(("clock", "plc", "was stepped")));
    }

    [Test]
    public void Look_ControlClockRunsAtAWrongRate_AddsAtMostOneEvent()
    {
        var plant = new VirtualPlant();
        plant.Add("plc", 1000, -3000);
        var events = new EventList(new SteppedTime(), (_, _) => { });
        var steps = new ClockSteps(plant.Clocks, events);
        for (var i = 0; i < 300; i++)
        {
            plant.Run(TimeSpan.FromSeconds(0.2));
            steps.Look();
        }

        Assert.That(plant.Clocks.Control.Model.Steps, Is.GreaterThan(5));
        Assert.That(events.Read(), Has.Count.LessThan(2));
    }
}
