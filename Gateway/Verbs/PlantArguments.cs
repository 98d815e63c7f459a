using System.CommandLine;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Plants;
using Nowpose.Simulation.Work;

namespace Nowpose.Gateway.Verbs;

/// <summary>The options of the commands "simulate" and "replay" for the robot and its samples.</summary>
sealed class PlantArguments
{
    readonly Option<string> _robot = TextOption.Create("--robot", RobotFiles.Names + " or the path of a .urdf file", "ROBOT", "youbot");

    readonly Option<double> _sampling = NumberOption.Create("--sampling-ms", "Sampling interval T_s", 50.0, 1, 1000, "ms");

    readonly Option<MillisecondRange> _acquisition = RangeOption.Create(
        "--acquisition-ms", "Delay that subscription and middleware add to each sample before it is sent", new MillisecondRange(55, 105), 1000);

    readonly Option<int> _seed = NumberOption.Create("--seed", "Seed of the random delays", 1, 0, int.MaxValue, "");

    readonly Option<bool> _trajectory = SwitchOption.Create(
        "--trajectory", "Also publish the set-points of the next second on /joint_trajectory, like a planner");

    readonly Option<int> _robots = NumberOption.Create(
        "--robots", "Number of robots: 2 stand at the same conveyor, in the namespaces arm1 and arm2", 1, 1, CellWork.MaxRobots, "");

    /// <summary>Adds the options to a command.</summary>
    /// <param name="command">The command.</param>
    /// <param name="mayHaveSeveral">Whether the command can serve several robots.</param>
    public void AddTo(Command command, bool mayHaveSeveral)
    {
        if (mayHaveSeveral) command.Options.Add(_robots);
        foreach (var option in new Option[] { _robot, _sampling, _acquisition, _seed, _trajectory })
            command.Options.Add(option);
    }

    /// <summary>The option that names the robot.</summary>
    public Option RobotOption => _robot;

    public string Robot(ParseResult parsed) => parsed.GetValue(_robot);
    public int Robots(ParseResult parsed) => Math.Max(1, parsed.GetValue(_robots));
    public bool PublishesPlan(ParseResult parsed) => parsed.GetValue(_trajectory);
    public int Seed(ParseResult parsed) => parsed.GetValue(_seed);

    public CellTiming Timing(ParseResult parsed)
    {
        var acquisition = parsed.GetValue(_acquisition);
        return new CellTiming(Milliseconds(parsed.GetValue(_sampling)), Milliseconds(acquisition.Min), Milliseconds(acquisition.Max));
    }

    static TimeSpan Milliseconds(double value) => new((long)Math.Round(value * TimeSpan.TicksPerMillisecond));
}
