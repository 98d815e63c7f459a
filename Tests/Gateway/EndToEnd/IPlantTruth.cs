using Nowpose.Kinematics;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>The true position of a plant, on a clock that only the plant has.</summary>
interface IPlantTruth
{
    /// <summary>The plant's clock at a moment on this machine's counter.</summary>
    ControlTime TimeAt(HeadsetTime headset);

    /// <summary>Gets the joint positions at a time of the plant's clock.</summary>
    /// <param name="positions">In the order of the robot's moving joints.</param>
    void TruthAt(RobotModel robot, ControlTime time, Span<double> positions);
}
