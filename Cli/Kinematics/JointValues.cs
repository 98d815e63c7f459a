using System.Globalization;
using Nowpose.Kinematics;

namespace Nowpose.Cli.Kinematics;

/// <summary>The values of <c>--joints</c>, validated against the robot.</summary>
sealed class JointValues
{
    readonly RobotModel _model;
    readonly double[] _positions;
    readonly bool[] _given;

    /// <param name="list"><c>name=value,name=value…</c>; null for no values.</param>
    public JointValues(RobotModel model, string list)
    {
        _model = model;
        _positions = new double[model.MovingJoints.Count];
        _given = new bool[model.MovingJoints.Count];
        if (list == null) return;
        foreach (var entry in list.Split(',', StringSplitOptions.TrimEntries)) Take(entry);
    }

    /// <summary>Gets the positions of all moving joints. Joints without a value are at 0; mimic joints follow the joint that they mimic.</summary>
    public double[] Complete()
    {
        var positions = (double[])_positions.Clone();
        _model.CompleteMimics(positions, _given);
        return positions;
    }

    /// <summary>Gets one sentence for each position outside the joint's limits, also for joints without a value.</summary>
    /// <param name="positions">The positions of <see cref="Complete"/>.</param>
    public IEnumerable<string> OutOfLimits(double[] positions)
    {
        for (var i = 0; i < positions.Length; i++)
        {
            var joint = _model.MovingJoints[i];
            if (!joint.Limits.Contains(positions[i])) yield return OutOfLimits(joint, positions[i]);
        }
    }

    static string OutOfLimits(RobotJoint joint, double value)
    {
        var unit = joint.Kind == JointKind.Prismatic ? "m" : "rad";
        return KinematicsMessages.BeyondLimits(joint.Name, value, unit, joint.Limits.Lower, joint.Limits.Upper);
    }

    void Take(string entry)
    {
        var split = entry.LastIndexOf('=');
        if (split < 1) throw new InputException(KinematicsMessages.NotAPair(entry));
        var index = MovingJoint(entry[..split].TrimEnd());
        if (_given[index]) throw new InputException(KinematicsMessages.JointTwice(_model.MovingJoints[index].Name));
        _given[index] = true;
        _positions[index] = Value(_model.MovingJoints[index], entry[(split + 1)..]);
    }

    int MovingJoint(string name)
    {
        var index = _model.IndexOfMovingJoint(name);
        if (index >= 0) return index;
        var reason = _model.Joints.Any(joint => joint.Name == name) ? KinematicsMessages.FixedJoint(name) : KinematicsMessages.UnknownJoint(name);
        var names = string.Join(", ", _model.MovingJoints.Select(joint => joint.Name));
        throw new InputException(
            names.Length == 0 ? KinematicsMessages.WithoutMovingJoint(reason) : KinematicsMessages.NotAMovingJoint(reason, names));
    }

    static double Value(RobotJoint joint, string text)
    {
        if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) && double.IsFinite(value))
            return value;
        var unit = joint.Kind == JointKind.Prismatic ? "m" : "rad";
        throw new InputException(KinematicsMessages.NotANumber(joint.Name, text, unit));
    }
}
