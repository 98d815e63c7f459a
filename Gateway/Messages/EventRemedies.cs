namespace Nowpose.Gateway.Messages;

/// <summary>Remedies for the events on the operations page.</summary>
static class EventRemedies
{
    public const string Source = "Check that its source is running and can reach the gateway.";
    public const string MissingJoint = "Check that the plant offers the joint's value and that the plant's configuration names it correctly.";
    public const string Values = "Check the values that its source sends.";
    public const string Plant = "Check the plant and its connection.";
    public const string Parent = "Check the name of the parent; if it is a link of a robot, check that a source publishes the robot's description.";
    public const string CellVariables = "Check its variables in the plant and its entry in the plant's configuration.";
    public const string ClockAdapter = "Check the adapter that reads this clock.";

    public const string ClockRate =
        "Check time.unit; for a simulation, stamp with a clock in real time, or wait until the time service has corrected the clock.";

    public const string ClockName = "Check the name in --clock, and the adapter that reads this clock.";
    public const string ClockNames = "Give each clock another name, or stop the client that does not belong to the plant.";
    public const string Adapters = "Check that the adapter of each plant is running and connected.";
    public const string GatewayLog = "Read the adapter's lines in the gateway's log.";
    public const string Adapter = "Check that the adapter is running and can reach the gateway.";
    public const string HeadsetPower = "Check the headset's power and its network.";
    public const string MissingJoints = "Check the sources of these joints.";
    public const string HeadsetNetwork = "Check the network between the headset and the gateway.";
    public const string LateSamples = "Check that samples reach the headset in time.";
    public const string StatusPanel = "Look at the status panel of the headset.";
    public const string TwoSources = "Stop one of the two sources.";

    public const string AdapterNames = "Set another plant.name for one of the two adapters, or stop one.";
    public const string HeadsetNames = "Set another Headset Name in the session settings of one of the two headsets.";
    public const string Connections = "Close clients that are not needed, or increase max-connections and start the gateway again.";

    public const string ConnectionsOfSource = "Close connections of this source that are not needed, give each source its own token, or increase "
        + "max-connections and start the gateway again.";

    public const string Address =
        "Restore the network or VPN with this address, after which the gateway needs no restart, or start it with another --bind.";

    public const string Descriptors = "Close clients that are not needed, or raise the limit on open files (ulimit -n, LimitNOFILE= of the systemd unit, "
        + "--ulimit nofile= of the container) and start the gateway again.";

    /// <summary>Gets the remedy for refused set-points; empty if the text of the reason contains it.</summary>
    public static string SetPoints(DropReason reason) => reason switch
    {
        DropReason.NotAllowed => "",
        DropReason.Unsynchronised => "Send the set-points again.",
        _ => "Correct this, then send the set-points again.",
    };

    public const string Description = "Correct it at its source; headsets cannot show the robot with it.";

    public static string Limits(string unit, string other) =>
        $"Check that the description belongs to this robot and contains its limits, and that the source sends {unit}; if it sends {other}, "
        + $"set unit: {other} in the file of the plant.";

    public const string RecordAgain = "Start the recording again to write a new file.";
    public const string Recording = "Correct this, then start the recording again.";
    public const string File = "Correct the file; the gateway needs no restart.";
    public const string RecordingDisk = "Check the disk of the folder for recordings.";
    public const string Certificate = "renew the file with the same key; the gateway needs no restart";

    public const string CheckRest = "Check that the joint is at rest.";
    public const string SetDeceleration = "Check that the joint is at rest; if it is, set its max_deceleration in the plant's configuration.";
}
