using System.Text;
using System.Text.Json;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>Checks the properties of rosbridge messages that the reader has accepted.</summary>
static class MessageRules
{
    /// <summary>
    /// Reads a message and returns whether it was accepted. An accepted message must be JSON, follow every rule, and be the same after it is written
    /// and read again. The reader keeps state between messages, so a new reader must return the same result.
    /// </summary>
    public static bool IsTaken(RosbridgeReader reader, byte[] utf8)
    {
        var isNewTaken = new RosbridgeReader().TryRead(utf8, out var alike, out var expected);
        if (reader.TryRead(utf8, out var message, out var reason) != isNewTaken || reason != expected)
            throw new FuzzException($"{reason} after other messages, {expected} as the first");
        if (message?.JointState is { } read && !read.Positions.AsSpan().SequenceEqual(alike.JointState.Positions))
            throw new FuzzException("reads otherwise after other messages");
        if (!isNewTaken) return reason == DropReason.None ? throw new FuzzException("refused without a reason") : false;
        Json(utf8, message);
        var isTaken = IsTaken(message, reason);
        // Releases the message as a session does, so that the next message is read into the same object.
        message.JointState?.Release();
        message.Transforms?.Release();
        message.Signals?.Release();
        return isTaken;
    }

    static bool IsTaken(RosbridgeMessage message, DropReason reason)
    {
        if (reason != DropReason.None) throw new FuzzException("taken with a reason: " + reason);
        if (message.JointState is { } state) Check(state);
        if (message.JointTrajectory is { } plan) Check(plan);
        if ((message.JointStatus ?? message.SignalStatus) is { } status) Check(status);
        if (message.Transforms is { } transforms) Check(transforms, isStatic: message.Topic == RosTopics.TfStatic);
        if (message.Signals is { } signals) Check(signals);
        if (message.Time is { } time) Stamp(time);
        if (message.PlantTime is { } plant) Check(plant);
        if (message.Data?.Length > ProtocolLimits.DescriptionBytes) throw new FuzzException("a description that is too long");
        return true;
    }

    // Compares with another JSON reader, which does not allow NaN and Infinity.
    static void Json(byte[] utf8, RosbridgeMessage message)
    {
        var text = new UTF8Encoding(false, true).GetString(utf8);
        // The other reader does not decode unpaired surrogates, either.
        if (text.Contains("NaN") || text.Contains("Infinity") || text.Contains("\\ud", StringComparison.OrdinalIgnoreCase)) return;
        using var document = JsonDocument.Parse(utf8);
        if (message.JointState is not { } state) return;
        var positions = document.RootElement.EnumerateObject().First(field => field.Name == "msg").Value
            .EnumerateObject().First(field => field.Name == "position").Value.EnumerateArray().Select(position => position.GetDouble());
        if (!positions.SequenceEqual(state.Positions)) throw new FuzzException("numbers that are others to System.Text.Json");
    }

    public static void Finite(double value)
    {
        if (!double.IsFinite(value)) throw new FuzzException(value + " passed");
    }

    static void Check(JointStateMessage state)
    {
        Stamp(state.Stamp);
        Names(state.Names);
        Numbers(state.Names.Length, state.Positions, state.Velocities, state.Accelerations);
        var text = RosbridgeWriter.Publish(RosTopics.JointStates, state, RosTimeForm.Secs);
        if (!RosbridgeReader.TryRead(text, out var again, out var reason)) throw new FuzzException($"not read again ({reason}): {text}");
        if (again.JointState.Stamp != state.Stamp || !again.JointState.Positions.AsSpan().SequenceEqual(state.Positions))
            throw new FuzzException("reads otherwise than written: " + text);
    }

    static void Check(TransformsMessage transforms, bool isStatic)
    {
        var all = Enumerable.Range(0, transforms.Count).Select(i => transforms[i]).ToArray();
        Names([.. all.Select(one => one.Child)]);
        foreach (var one in all)
        {
            if (!isStatic || one.Stamp != default) Stamp(one.Stamp);
            Names([one.Parent], mayHaveNamespaces: true);
            if (one.Parent == one.Child) throw new FuzzException("a frame is its own parent");
            foreach (var number in new[] { one.X, one.Y, one.Z, one.Qx, one.Qy, one.Qz, one.Qw }) Finite(number);
            var norm = (one.Qx * one.Qx) + (one.Qy * one.Qy) + (one.Qz * one.Qz) + (one.Qw * one.Qw);
            if (Math.Abs(norm - 1) > 1e-14) throw new FuzzException("a quaternion with the squared norm " + norm);
        }

        var text = RosbridgeWriter.Publish(isStatic ? RosTopics.TfStatic : RosTopics.Tf, transforms, RosTimeForm.Secs);
        if (!RosbridgeReader.TryRead(text, out var again, out var reason)) throw new FuzzException($"not read again ({reason}): {text}");
        for (var i = 0; i < all.Length; i++)
            if (again.Transforms[i].Stamp != all[i].Stamp || again.Transforms[i].Child != all[i].Child || again.Transforms[i].X != all[i].X)
                throw new FuzzException("reads otherwise than written: " + text);
    }

    static void Check(SignalsMessage signals)
    {
        Stamp(signals.Stamp);
        var all = Enumerable.Range(0, signals.Count).Select(i => signals[i]).ToArray();
        Names([.. all.Select(one => one.Name)]);
        foreach (var one in all) Finite(one.Value);
        var text = RosbridgeWriter.Publish(RosTopics.Signals, signals, RosTimeForm.Secs);
        if (!RosbridgeReader.TryRead(text, out var again, out var reason)) throw new FuzzException($"not read again ({reason}): {text}");
        for (var i = 0; i < all.Length; i++)
            if (again.Signals.Stamp != signals.Stamp || again.Signals[i].Name != all[i].Name || again.Signals[i].Value != all[i].Value)
                throw new FuzzException("reads otherwise than written: " + text);
    }

    static void Check(JointTrajectoryMessage plan)
    {
        Stamp(plan.Stamp);
        Names(plan.Names);
        var before = TimeSpan.FromTicks(-1);
        foreach (var point in plan.Points)
        {
            Numbers(plan.Names.Length, point.Positions, point.Velocities, point.Accelerations);
            if (point.TimeFromStart <= before) throw new FuzzException("points that go back");
            before = point.TimeFromStart;
        }
    }

    static void Check(JointStatusMessage status)
    {
        Names([.. status.Joints.Select(joint => joint.Joint)], mayHaveNamespaces: true);
        foreach (var joint in status.Joints)
        {
            if (!Enum.IsDefined(joint.State)) throw new FuzzException("state " + joint.State);
            if (joint.Since.SinceEpoch.Duration().TotalSeconds >= 1L << 32 || joint.Reason.Length > 256 || joint.Reason.Any(char.IsControl))
                throw new FuzzException("a time out of range, or a reason that is not one short line");
        }
    }

    static void Check(PlantTimeMessage plant)
    {
        Stamp(plant.Received);
        Stamp(plant.Sent);
        if (plant.Resolution < TimeSpan.Zero || plant.ErrorBound < TimeSpan.Zero) throw new FuzzException("a negative length");
    }

    static void Numbers(int joints, double[] positions, double[] velocities, double[] accelerations)
    {
        if (positions.Length != joints || (velocities ?? positions).Length != joints || (accelerations ?? positions).Length != joints)
            throw new FuzzException("lengths differ");
        foreach (var position in positions) Finite(position);
        // NaN means that the value is absent.
        foreach (var rate in (velocities ?? []).Concat(accelerations ?? []))
            if (double.IsInfinity(rate)) throw new FuzzException(rate + " passed");
    }

    static void Names(string[] names, bool mayHaveNamespaces = false)
    {
        if (names.Length > ProtocolLimits.Joints || names.Distinct().Count() != names.Length
            || names.Any(name => name.Length == 0 || (mayHaveNamespaces ? !RobotTopic.HasNameLength(name) : name.Length > ProtocolLimits.NameLength)))
            throw new FuzzException("names that are too many, too long, empty or twice there");
    }

    static void Stamp(ControlTime stamp)
    {
        if (stamp.SinceEpoch <= TimeSpan.Zero || stamp.SinceEpoch.TotalSeconds >= 1L << 32) throw new FuzzException("stamp " + stamp.SinceEpoch);
    }
}
