using System.CommandLine;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;

namespace Nowpose.Cli.Kinematics;

/// <summary><c>kinematics FILE.urdf</c>: computes link poses from joint values.</summary>
static class KinematicsVerb
{
    public static Command Create()
    {
        var file = new Argument<string>("FILE.urdf") { Description = $"The robot: a URDF, or one of {RobotFiles.Names}." };
        var joints = TextOption.Create(
            "--joints", "Joint values in rad (prismatic: m), for example a=0.1,b=-0.2. Other joints are at 0; "
                + "mimic joints without a value follow the joint that they mimic.");
        var json = SwitchOption.Create("--json", "Print JSON instead of matrices");
        var verb = new Command("kinematics", "Compute the poses of all links relative to the root link.") { file, joints, json };
        verb.SetAction((parsed, cancel) => Invocation.ReadAsync(
            () => Run(parsed.GetValue(file), parsed.GetValue(joints), parsed.GetValue(json)), cancel));
        return verb;
    }

    static int Run(string file, string joints, bool json)
    {
        var model = RobotFiles.Load(file);
        var values = new JointValues(model, joints);
        var positions = values.Complete();
        var poses = Poses(model, positions);
        foreach (var note in values.OutOfLimits(positions))
            Console.Error.WriteLine(ConsoleMessages.Line(note));
        Console.Out.Write(json ? PoseOutput.Json(model, poses) : PoseOutput.Matrices(model, poses));
        return ExitStatus.Done;
    }

    static double[][] Poses(RobotModel model, double[] positions)
    {
        var poses = new RigidTransform[model.Links.Count];
        new ForwardKinematics(model).Compute(positions, poses);
        var matrices = Array.ConvertAll(poses, pose => pose.ToRowMajor16());
        if (!matrices.All(matrix => matrix.All(double.IsFinite)))
            throw new InputException(KinematicsMessages.TooLarge);
        return matrices;
    }
}
