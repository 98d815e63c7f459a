using Nowpose.Kinematics;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Where a plant truly is, on a clock that only it has.</summary>
interface IPlantTruth
{
    /// <summary>The plant's clock at a moment on this machine's counter.</summary>
    ControlTime TimeAt(HeadsetTime headset);

    /// <summary>Where its joints are at a time of its clock.</summary>
    /// <param name="positions">In the order of the robot's moving joints.</param>
    void TruthAt(RobotModel robot, ControlTime time, Span<double> positions);
}
