using System.Globalization;
using System.Net;
using Nowpose.Messages;

namespace Nowpose.Gateway.Messages;

/// <summary>Headlines of events on the operations page, and the reasons for the events.</summary>
static class EventTexts
{
    public const string DoesNotReport = "does not report";
    public const string ReportsStopped = "its reports stopped";
    public const string InFault = "is in fault";
    public const string NotServed = "is not served";
    public const string OfJointPositions = "of joint positions";
    public const string IsMissing = "is missing";
    public const string IsNotConnected = "is not connected";
    public const string IsLost = "is lost";
    public const string IsRefused = "is refused";
    public const string IsExceeded = "is exceeded";
    public const string ExceedsRate = "sends too many messages, of which the gateway drops some";
    public const string Stopped = "stopped";
    public const string IsInvalid = "is invalid";
    public const string IsIncomplete = "is incomplete";
    public const string OfTheGateway = "of the gateway";
    public const string HasExpired = "has expired";
    public const string IsOrphan = "is an orphan";
    public const string HasNoSource = "has no source";

    /// <param name="state">Name of the state of a joint, frame or signal.</param>
    public static string Is(string state) => $"is {state}";

    public static string ClockState(string state) => $"its state is {state}";

    /// <param name="offered">Names of the clocks that adapters have offered.</param>
    public static string ClockNotOffered(IReadOnlyCollection<string> offered) =>
        "no adapter has offered this clock" + (offered.Count == 0 ? "" : $"; the adapters have offered {string.Join(", ", offered)}");

    public static string ControlClock(string clock) => $"the control clock {clock}";
    public static string SourceOf(string source, string what) => $"{source} of {what}";
    public static string Pose(string pose) => $"the pose is {pose}";
    public static string ExpiresOn(string day, string remedy) => $"it expires on {day}; {remedy}";
    public static string SourceEnded(string source) => $"its source {source} has ended";

    public const string ThisGateway = "this gateway";
    public const string NotComparable = "time stamps from before the step cannot be compared with later ones";

    public static string ClockStepped(string clock) => $"the control clock {clock} was stepped";

    public const string OwnClock = "the gateway's own control clock";

    public static string ClockNotServed(string clock) => $"{clock} is not served to headsets";

    public const string RunsAtWrongRate = "does not run in real time";

    /// <param name="rate">Seconds of the clock per second of real time.</param>
    public static string ClockAtWrongRate(string clock, double rate) => $"the plant's clock {clock} runs at {RateText(rate)} times real time";

    /// <summary>Gets the reason for which no joint is current.</summary>
    public static string JointsOfWrongRate(string clock, double rate) => $"{ClockAtWrongRate(clock, rate)}. {EventRemedies.ClockRate}";

    public const string StampsContradict = "contradicts the stamps of samples";

    public static string StampsContradictClock(string clock) => $"{clock} and the stamps of samples contradict each other";

    public const string NotSystemClock = "does not follow the system clock";

    public static string ClockNotSystemClock(string clock) => $"{clock} does not follow the system clock";

    /// <param name="kind">Kind of the events.</param>
    public static string OtherEvents(string kind) => $"other events of the kind {kind}";

    public const string HasTwoTimes = "has two different times";

    public static string ClockWithTwoTimes(string clock) => $"two clients offer the clock {clock} with different times";

    /// <param name="client">The client that serves the clock.</param>
    public static string TimesDiffer(string other, string client, double aheadMs) => FormattableString.Invariant(
        $"the clock of {other} is {Math.Abs(aheadMs):0.0} ms {(aheadMs < 0 ? "behind" : "ahead of")} that of {client}, which is the served one");

    public const string Future = "sends time stamps in the future";

    public static string FutureBy(string by) => $"they are {by} ahead of the control clock";

    public const string TooOld = "sends samples that are too old to be displayed";

    public static string TooOldBy(string by) =>
        $"their time stamps are {by} behind the control clock, so headsets with default settings show no current pose";

    /// <param name="what">What the source does: <see cref="Future"/> or <see cref="TooOld"/>.</param>
    public static string SourceDoes(string source, string what) => $"source {source} {what}";

    public const string NoSource = "no adapter has reported a joint and no sample has arrived";
    public const string SourceMissing = "a source of joint positions is missing";

    public static string ProgramEnded(string end) => $"its program ended with {end}";

    public const string ProgramStarted = "its program has just started";

    public static string StartedAgain(string end) => $"{end} and is started again";
    public static string NotConnected(string adapter) => $"adapter {adapter} is not connected to its plant";

    public const string HasNotice = "reports a warning";
    public const string OtherVersion = "is not compatible with this gateway";
    public const string NoCurrentPose = "shows no current pose";
    public const string HeadsetLost = "its reports stopped without a normal end of the connection";

    public static string MissingJoints(string pose, string joints) => $"the pose is {pose}; missing joints: {joints}";
    public static string Taken(string owner, string kind) => $"the source {owner} already publishes this {kind}";
    public const string HasUsedName = "has the same name as another client";
    public static string NameUsed(string client) => $"the reports of {client} are refused, because another client uses this name";

    public const string LimitReached = "has reached the maximum number of connections";

    /// <param name="port">sync or websocket.</param>
    public static string PortLimitReached(string port) => $"the {port} port {LimitReached}";

    public static string Connections(int max, long refused) => FormattableString.Invariant(
        $"the maximum is {max}; connections refused since the start of the gateway: {refused}");

    public const string SourceLimitReached = "refuses connections of a source with its maximum number of connections";

    /// <param name="port">sync or websocket.</param>
    public static string PortSourceLimitReached(string port) => $"the {port} port {SourceLimitReached}";

    public static string RefusedOfSources(long refused) => FormattableString.Invariant(
        $"connections refused for this reason since the start of the gateway: {refused}");

    public const string NoAddress = "is not an address of this machine";
    public const string NoClientReachesAddress = "no client can connect to the gateway";

    public static string AddressMissing(IPAddress address) => $"the gateway's address {address} {NoAddress}";

    public const string NoDescriptor = "refuses connections because of too few file descriptors";

    /// <param name="port">sync or websocket.</param>
    public static string PortWithoutDescriptor(string port) => $"the {port} port {NoDescriptor}";

    public static string RefusedForDescriptors(long refused) => FormattableString.Invariant(
        $"failed attempts to accept a connection since the start of the gateway: {refused}");

    public static string SetPointsTaken(string owner, string joint) => $"the source {owner} already publishes set-points of joint {joint}";

    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    public static string SetPointsOf(string robot) => robot.Length == 0 ? "the set-points" : $"the set-points of robot {robot}";

    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    public static string InvalidDescription(string robot) => $"{DescriptionOf(robot)} {IsInvalid}";

    /// <inheritdoc cref="InvalidDescription" path="/param"/>
    public static string RefusedDescription(string robot, string source) => $"{DescriptionOf(robot)} from source {source} {IsRefused}";

    public static string SourceRefused(string source, string what) => $"source {source} is refused for {what}";

    public static string BeyondLimits(double position, string unit, double lower, double upper) =>
        $"its position was {RobotMessages.Short(position)} {unit}; allowed: {RobotMessages.Short(lower)} to {RobotMessages.Short(upper)} {unit}";

    public static string JointBeyondLimits(string joint) => $"joint {joint} is outside the limits of the robot description";

    public static string LinesMissing(long lines) =>
        FormattableString.Invariant($"{lines} lines are missing, because the disk did not store them in time");

    public const string Expires = "is about to expire";
    public const string CertificateExpires = "the gateway's certificate is about to expire";

    public static string HeadsetsRefuse(string day, string remedy) => $"headsets have refused it since {day}; {remedy}";

    public const string CertificateExpired = "the gateway's certificate has expired";
    public static string NotUpdated(string reason) => $"status: the state could not be updated ({reason})";

    public const string UncertainRest = "may not be at rest";

    /// <inheritdoc cref="StateNames.UncertainRestReason"/>
    public const string UncertainRestReason = StateNames.UncertainRestReason;

    static string DescriptionOf(string robot) => robot.Length == 0 ? "the robot description" : $"the description of robot {robot}";

    // Two digits, or enough digits to show the difference from real time.
    static string RateText(double rate) =>
        rate.ToString(rate < 0.05 ? "G2" : Math.Abs(rate - 1) < 0.05 ? "0.00##" : "F2", CultureInfo.InvariantCulture);
}
