using Nowpose.Kinematics;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Computes the true positions of a plant as functions of the plant's own clock.</summary>
interface IPlantTruth
{
    /// <summary>Converts a time on this machine's counter to a time on the plant's clock.</summary>
    ControlTime TimeAt(HeadsetTime headset);

    /// <summary>Computes the joint positions at a given time of the plant's clock.</summary>
    /// <param name="positions">Receives the positions (rad or m) in the order of the robot's moving joints.</param>
    void TruthAt(RobotModel robot, ControlTime time, Span<double> positions);
}
