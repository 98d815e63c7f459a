using System;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Session.Hindcast;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;

namespace Nowpose.Unity.Status
{
    /// <summary>
    /// Determines the strings that the status panel shows: a label, a value and a note for each row. "!" marks a problem, "–" an unknown value.
    /// </summary>
    /// <remarks>
    /// Most strings are preallocated. <see cref="Update"/> allocates only when the message, the latency profile or the state of a joint changes, and,
    /// while the errors of the joints are shown, when one of their numbers changes.
    /// </remarks>
    sealed class StatusTexts
    {
        public const int Rows = (int)StatusRow.Message + 1;

        /// <summary>
        /// Maximum number of lines of the message. A longer message is truncated on the panel; the log contains the complete message.
        /// </summary>
        public const int MaxMessageLines = 8;

        const string Unknown = NumberTexts.Unknown;

        static readonly string[] Poses = WordsOfPoses();
        static readonly string HeldOutside = "! " + PoseMessages.Of(PoseState.OutsideRange, OutsideRangeResponse.Hold);

        static readonly NumberTexts Milliseconds = new NumberTexts("", " ms", (2, 1, 0));
        static readonly NumberTexts MarkedMilliseconds = new NumberTexts("! ", " ms", (2, 1, 0));
        static readonly NumberTexts Bounds = new NumberTexts("± ", " ms", (2, 1, 0));
        static readonly NumberTexts CoarseClock = new NumberTexts(StatusMessages.ClockPrefix, " ms", (2, 1, 0));
        static readonly NumberTexts Percentiles = new NumberTexts(StatusMessages.PercentilePrefix, " ms", (0, 0, 0));
        static readonly NumberTexts Percents = new NumberTexts("", " %", (0, 0, 0));
        static readonly NumberTexts PercentBounds = new NumberTexts("± ", " %", (0, 0, 0));
        static readonly NumberTexts Millimetres = new NumberTexts("", " mm", (1, 1, 0));
        static readonly NumberTexts MillimetrePercentiles = new NumberTexts(StatusMessages.PercentilePrefix, " mm", (1, 1, 0));

        readonly string[] _labels = (string[])StatusMessages.Labels.Clone();
        readonly string[] _values = new string[Rows];
        readonly string[] _notes = new string[Rows];
        SessionSettings _settings;
        readonly JointErrorLine _joints = new JointErrorLine();
        readonly LatencyOrigin _origin = new LatencyOrigin();
        readonly BaseTexts _base = new BaseTexts();
        readonly JointStatusLine _missingJoints, _restingJoints;
        bool _isLocal;
        readonly (string Of, string Text)[] _partValues = new (string, string)[StatusRow.Message - StatusRow.FirstPart];
        readonly (string Of, string Text)[] _partNotes = new (string, string)[StatusRow.Message - StatusRow.FirstPart];
        readonly SinceText[] _partTimes = new SinceText[StatusRow.Message - StatusRow.FirstPart];
        readonly Func<DateTime> _wallClock;
        (string Of, string Text) _robot;
        (int Of, string Text) _further;
        string _message;

        /// <summary>Number of lines of the message; 0 if there is none.</summary>
        public int MessageLines { get; private set; }

        public StatusTexts() : this(() => DateTime.Now) { }

        /// <param name="wallClock">Returns the local time. It is used to show the time of day at which the data of a joint or part stopped.</param>
        public StatusTexts(Func<DateTime> wallClock)
        {
            _wallClock = wallClock;
            for (var i = 0; i < _partTimes.Length; i++) _partTimes[i] = new SinceText();
            _missingJoints = new JointStatusLine(isOfMissing: true, wallClock);
            _restingJoints = new JointStatusLine(isOfMissing: false, wallClock);
            Update(null, null, null, null);
        }

        /// <summary>Whether the message shows the error reduction of each joint while no other message is shown.</summary>
        public bool ShowsJointErrors { get; set; }

        /// <summary>Returns the label of a row. The label of a part that is not current is the time since when.</summary>
        public string LabelOf(StatusRow row) => _labels[(int)row];

        public string ValueOf(StatusRow row) => _values[(int)row];

        public string NoteOf(StatusRow row) => _notes[(int)row];

        /// <summary>Returns whether a row has a value or a note. A row without both takes no space.</summary>
        public bool IsShown(StatusRow row) =>
            !string.IsNullOrEmpty(_values[(int)row]) || !string.IsNullOrEmpty(_notes[(int)row]);

        /// <summary>Updates all strings.</summary>
        /// <param name="statistics">Statistics of the session; null if no session exists.</param>
        /// <param name="settings">Settings of the session; null if they are unknown.</param>
        /// <param name="robot">Name of the robot; null if it is unknown.</param>
        /// <param name="problem">Reason why the session could not start; null if no problem is known.</param>
        /// <param name="anchor">Anchor of the base; null if there is none.</param>
        /// <param name="pairing">Pairing of the session; null if there is none.</param>
        /// <param name="parts">Shown objects and signals of the cell; null if there are none.</param>
        /// <param name="nudge">Calibration by eye; null if there is none.</param>
        public void Update(
            SessionStatistics statistics, SessionSettings settings, string robot, string problem, BaseAnchor anchor = null,
            CellPairing pairing = null, ShownParts parts = null, LatencyNudge nudge = null)
        {
            for (var row = StatusRow.Pose; row < StatusRow.Message; row++) Set(row, Unknown, "");
            if (statistics != null)
            {
                UpdateTimes(statistics);
                UpdateLatencies(statistics);
                Follow(settings);
                Set(StatusRow.Connection, StatusMessages.Of(statistics.SyncLink.State, statistics.SampleLink.State),
                    StatusMessages.Of(statistics.Security, _isLocal));
                Set(StatusRow.Robot, RobotOf(statistics), Shortened(robot ?? "", "", ref _robot, PanelCells.NoteWidth));
            }
            if (anchor != null) Set(StatusRow.Base, StatusMessages.Of(anchor.State), _base.NoteOf(anchor));
            parts?.Update();
            Set(StatusRow.Objects, parts?.Summary ?? "", "");
            var (isPairing, isNudging) = (pairing != null, nudge != null && nudge.isActiveAndEnabled);
            // Problems with the pairing have priority, because the connections and the base depend on the pairing.
            var obstacle = problem ?? (isPairing ? pairing.Obstacle : null);
            var guidance = obstacle == null && isPairing ? pairing.Guidance : null;
            var fault = obstacle ?? FaultOf(statistics) ?? _missingJoints.Of(statistics) ?? _base.FaultOf(anchor) ?? (isPairing ? pairing.Problem : null)
                ?? DisplayMessages.ProblemOf(statistics) ?? statistics?.VersionMismatch ?? statistics?.SampleLink.Warning ?? (isNudging ? nudge.Problem : null);
            if (guidance != null) SetMessage(guidance, "");
            else if (fault != null) SetMessage(fault, "! ");
            else SetMessage((isNudging ? nudge.Progress : null) ?? _restingJoints.Of(statistics)
                ?? (ShowsJointErrors && statistics != null ? _joints.Of(statistics.JointErrors) : null), "");
            UpdateParts(parts, statistics?.Now);
        }

        void UpdateTimes(SessionStatistics statistics)
        {
            var clock = statistics.Clock;
            var isCoarse = statistics.SettledPose == PoseState.Current && statistics.IsClockCoarse;
            Set(StatusRow.Pose, PoseOf(statistics), isCoarse ? CoarseClock.Of(clock.EstimatedError)
                : StatusMessages.ReasonOf(statistics.SettledPose, statistics.IsSettledLimitedByBase));
            Set(StatusRow.Clock, StatusMessages.Of(clock.State), clock.IsKnown ? Bounds.Of(clock.EstimatedError) : "");
            Set(StatusRow.Horizon, Milliseconds.Of(statistics.Horizon), "");
        }

        void UpdateLatencies(SessionStatistics statistics)
        {
            var percentile = statistics.ApplicationLatency95;
            var application = statistics.OwnRobot.AreStampsAhead ? MarkedMilliseconds : Milliseconds;
            Set(StatusRow.ApplicationLatency, application.Of(statistics.ApplicationLatency), percentile.HasValue ? Percentiles.Of(percentile) : "");
            var isUncertain = statistics.IsDisplayTimeImplausible || DisplayMessages.IsMismatched(statistics)
                || (statistics.IsDisplayTimeInconsistent && statistics.Profile != null);
            var visualisation = isUncertain ? MarkedMilliseconds : Milliseconds;
            Set(StatusRow.VisualisationLatency, visualisation.Of(statistics.VisualisationLatency), _origin.Of(statistics));
            Set(StatusRow.RenderTime, Milliseconds.Of(statistics.RenderTime), RenderTimeNames.NameOf(statistics.RenderTimeSource));
            Set(StatusRow.Range, RangeOf(statistics.Range), StatusMessages.Of(statistics.RangeUnknownReason) ?? "");
            UpdateError(statistics.ToolError, WithheldErrors.WordsOf(statistics.ErrorWithheld) ?? "");
        }

        /// <param name="error">The error of the tool; null if it is unknown.</param>
        /// <param name="withheld">Reason why the error is withheld; empty if it is not withheld.</param>
        void UpdateError(DisplayedError? error, string withheld)
        {
            var uncertainty = error?.ReductionUncertainty;
            Set(StatusRow.Reduction, Percents.Of(error?.Reduction * 100), uncertainty.HasValue ? PercentBounds.Of(uncertainty * 100) : withheld);
            Set(StatusRow.Error, Millimetres.Of(error?.Rms), error.HasValue ? MillimetrePercentiles.Of(error.Value.P95) : withheld);
        }

        // Lists the parts with a fault of their own; other rows report a fault that affects all parts. A longer message leaves less space, so that the
        // panel stays in view.
        void UpdateParts(ShownParts parts, ControlTime? now)
        {
            var faults = parts?.FaultCount ?? 0;
            var rows = Math.Min(StatusRow.Message - StatusRow.FirstPart, MaxMessageLines - 1 - MessageLines);
            for (var row = StatusRow.FirstPart; row <= StatusRow.LastPart; row++)
            {
                var i = row - StatusRow.FirstPart;
                var isNamed = i < Math.Min(faults, rows) && (i < rows - 1 || faults == rows);
                _labels[(int)row] = isNamed ? _partTimes[i].Of(now - parts.SinceOf(i), _wallClock()) : "";
                if (isNamed)
                    Set(row, Shortened(parts.FaultyTitle(i), "! ", ref _partValues[i], PanelCells.ValueWidth),
                        Shortened(parts.FaultOf(i), "", ref _partNotes[i], PanelCells.NoteWidth));
                else Set(row, i == rows - 1 && faults > rows ? Further(faults - i) : "", "");
            }
        }

        string Further(int count)
        {
            if (_further.Of != count) _further = (count, StatusMessages.FurtherParts(count));
            return _further.Text;
        }

        // Shortens a string of any length to one line. Keeps the result until the string changes.
        static string Shortened(string text, string mark, ref (string Of, string Text) kept, float width)
        {
            if (!ReferenceEquals(text, kept.Of) && text != kept.Of) kept.Text = WrappedText.Of(mark + text, width, lines: 1);
            kept.Of = text;
            return kept.Text;
        }

        // Reads the address only if the settings have changed, because reading allocates.
        void Follow(SessionSettings settings)
        {
            if (settings == _settings) return;
            _settings = settings;
            _isLocal = settings != null && settings.Connection.IsLoopback;
        }

        void Set(StatusRow row, string value, string note)
        {
            _values[(int)row] = value;
            _notes[(int)row] = note;
        }

        void SetMessage(string message, string mark)
        {
            if (message == _message && _values[(int)StatusRow.Message] != null) return;
            _message = message;
            var text = string.IsNullOrEmpty(message) ? "" : WrappedText.Of(mark + message, PanelCells.MessageWidth, MaxMessageLines);
            MessageLines = text.Length == 0 ? 0 : text.Split('\n').Length;
            Set(StatusRow.Message, text, "");
        }

        static string PoseOf(SessionStatistics statistics) =>
            statistics.SettledPose == PoseState.OutsideRange && statistics.OutsideRange == OutsideRangeResponse.Hold
                ? HeldOutside : Poses[(int)statistics.SettledPose];

        static string[] WordsOfPoses()
        {
            var words = new string[(int)PoseState.Current + 1];
            for (var pose = PoseState.Incomplete; pose < PoseState.Current; pose++) words[(int)pose] = "! " + PoseMessages.Of(pose);
            words[(int)PoseState.Current] = PoseMessages.Of(PoseState.Current);
            return words;
        }

        static string RangeOf(RangeState range)
        {
            switch (range)
            {
                case RangeState.Inside: return StatusMessages.InsideRange;
                case RangeState.Outside: return StatusMessages.OutsideRange;
                default: return Unknown;
            }
        }

        static string RobotOf(SessionStatistics statistics)
        {
            if (statistics.BeyondLimits != null) return StatusMessages.BeyondLimits;
            switch (statistics.RobotDescriptionMatch)
            {
                case RobotDescriptionMatch.Same: return StatusMessages.SameRobot;
                case RobotDescriptionMatch.Different: return StatusMessages.OtherRobot;
                default: return Unknown;
            }
        }

        static string FaultOf(SessionStatistics statistics)
        {
            if (statistics == null) return null;
            if (statistics.SyncLink.State == LinkState.Waiting) return statistics.SyncLink.Detail;
            return statistics.SampleLink.State == LinkState.Waiting ? statistics.SampleLink.Detail : statistics.OwnRobot.OtherNamespaces;
        }
    }
}
