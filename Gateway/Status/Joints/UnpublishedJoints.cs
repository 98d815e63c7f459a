using Nowpose.Kinematics;
using Nowpose.Session;

namespace Nowpose.Gateway.Status.Joints;

/// <summary>Finds the arm joints of a robot that no source publishes although another arm joint has a source. Not thread-safe.</summary>
/// <remarks>Headsets cannot show a current pose without these joints. Gripper joints and mimic joints need no source.</remarks>
sealed class UnpublishedJoints(TimeProvider time)
{
    /// <summary>Text shown as the source of these joints.</summary>
    internal const string NoSource = "no source";

    /// <summary>Time after which an unpublished joint is reported. In this time, all sources of one arm can start one after the other.</summary>
    internal static readonly TimeSpan StartTimeout = TimeSpan.FromSeconds(1);

    readonly Dictionary<(string Robot, string Name), (long Count, DateTimeOffset Utc)> _since = [];

    /// <summary>Gets the unpublished joints.</summary>
    /// <param name="robots">The described robots with their namespaces.</param>
    /// <param name="hasSource">Returns whether a source publishes a joint or an adapter has the joint in its configuration.</param>
    public IEnumerable<JointSnapshot> Judge(IEnumerable<(string Namespace, RobotModel Model)> robots, Func<string, bool> hasSource)
    {
        var missing = robots.SelectMany(robot =>
            MissingOf(NamesOf(robot.Model).ConvertAll(name => RobotTopic.Qualified(robot.Namespace, name)), hasSource)
                .Select(name => (robot.Namespace, name))).ToArray();
        foreach (var name in _since.Keys.Except(missing).ToArray()) _since.Remove(name);
        foreach (var name in missing) _since.TryAdd(name, (time.GetTimestamp(), time.GetUtcNow()));
        return _since.Where(entry => time.GetElapsedTime(entry.Value.Count) >= StartTimeout).Select(entry => new JointSnapshot(
            entry.Key.Name, NoSource, JointDataState.Missing, entry.Value.Utc, null, 0, JointReasons.NotPublished)
        {
            Robot = entry.Key.Robot,
            ReasonWord = JointFaultReasons.NotPublished,
        });
    }

    static List<string> MissingOf(List<string> joints, Func<string, bool> hasSource) =>
        joints.Exists(hasSource.Invoke) ? joints.FindAll(name => !hasSource(name)) : [];

    /// <summary>Gets the names of the joints whose positions headsets need to show the arm.</summary>
    internal static List<string> NamesOf(RobotModel robot) => [.. ToolJoints.Of(robot).Select(joint => robot.MovingJoints[joint].Name)];
}
