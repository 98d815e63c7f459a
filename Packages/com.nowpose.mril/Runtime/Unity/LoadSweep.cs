using System;
using System.Threading.Tasks;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Sweep;
using Nowpose.Session;
using Nowpose.Unity.Calibration;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.Events;
using UnityEngine.Serialization;

namespace Nowpose.Unity
{
    /// <summary>
    /// Steps through rendering loads. Logs the load, the render time and the control time of the timestamp code for each frame.
    /// </summary>
    /// <remarks>
    /// Measures Fig. 11 of Schnierle &amp; Röck 2022: the timestamp codes in the pictures of a camera relate the pictures to the log. The time for a
    /// load starts when the load is complete and the clock is synchronised. Frames never wait for the disk. The component allocates only when the
    /// load changes, or when a load takes so long that its rows need more space.
    /// </remarks>
    [AddComponentMenu("Nowpose/Load Sweep")]
    [DisallowMultipleComponent]
    public sealed class LoadSweep : MonoBehaviour
    {
        /// <summary>
        /// MaxHz: expected maximum display rate, Hz. SecondsToBuild: expected time to build a load, s. They determine the initial capacity for rows.
        /// </summary>
        const int MaxHz = 144, SecondsToBuild = 3;

        [SerializeField, Tooltip("The session whose frames are logged. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("The generator of the load. Empty: the generator on this object or a child.")]
        LoadGenerator _load = null;

        [SerializeField, Tooltip("The component that measures the render time. Empty: the one on the session's object or a child.")]
        RenderTimeSource _renderTime = null;

        [FormerlySerializedAs("_mostVertices")]
        [SerializeField, Range(1000, SweepPlan.MaxVertices), Tooltip("Maximum load in vertices. Default 2000000: more than a headset can draw in "
            + "time, so that the sweep passes the limit.")]
        int _maxVertices = SweepPlan.MaxVertices;

        [SerializeField, Range(2, 100), Tooltip("Number of equal steps from no load to the maximum. 10 steps locate the limit within 5 %, 20 "
            + "steps within 2 %.")]
        int _steps = 10;

        [SerializeField, Range(0.5f, 600), Tooltip("Duration of each load in seconds. Default 5: about 40 pictures at eight per second.")]
        float _secondsPerLoad = 5;

        [SerializeField, Range(0, 60), Tooltip("Waiting time in seconds before each load, in which the GPU's queue settles. Frames in this time "
            + "are logged too, but do not affect the fit.")]
        float _settleSeconds = 1;

        [SerializeField, Tooltip("Repeat the loads in reverse order. Otherwise, a processor that warms up would look like an effect of the "
            + "load.")]
        bool _goesDown = true;

        [SerializeField, Tooltip("Folder for the logs: a path below the application's persistent data path, or a full path. It is created if it "
            + "does not exist. A HoloLens shows the persistent data path as LocalState in its device portal.")]
        string _folder = "calibration";

        [SerializeField, Tooltip("Start when this component is enabled. Off by default, because the camera must be set up first.")]
        bool _startOnEnable = false;

        [SerializeField, Tooltip("Text Mesh that shows the progress. Empty: none.")]
        TextMesh _text = null;

        [SerializeField, Tooltip("Called when the sweep is complete and its log is written and evaluated.")]
        UnityEvent _onDone = new UnityEvent();

        MrilSession _source;
        LoadGenerator _generator;
        RenderTimeSource _measures;
        readonly Listeners<Action> _progressed = new Listeners<Action>();
        SweepPlan _plan;
        SweepRun _run;
        SweepFile _file;
        SweepFrame? _frame;
        Task<LoadSensitivity> _judging, _closing = Task.FromResult<LoadSensitivity>(null);
        DisplayConditions _conditions;
        double _displayHz;
        int _verticesBefore;
        (int Index, int Phase) _logged;

        /// <summary>Raised when <see cref="Words"/> changes.</summary>
        public event Action Progressed { add => _progressed.Add(value); remove => _progressed.Remove(value); }

        /// <summary>Whether a sweep is running.</summary>
        public bool IsRunning => _run != null;

        /// <summary>Describes the progress in a few words; null before the first sweep.</summary>
        [field: NonSerialized] public string Words { get; private set; }

        /// <summary>Path of the current or last log; null before the first sweep.</summary>
        [field: NonSerialized] public string Path { get; private set; }

        /// <summary>Result of the last sweep: whether the render time depends on the load. Null until a sweep is complete.</summary>
        public LoadSensitivity Verdict { get; private set; }

        /// <summary>Reason why a sweep did not start or ended early, in one line; null if no problem is known.</summary>
        [field: NonSerialized] public string Problem { get; private set; }

        /// <summary>Task that completes when the log of the last sweep is closed.</summary>
        internal Task Closed => _closing;

        /// <summary>Starts a sweep from the first load, with a new log. Does nothing while a sweep is running.</summary>
        public void StartSweep()
        {
            EndEvaluation();
            if (IsRunning) return;
            (Verdict, Problem) = (null, null);
            _source = this.SessionOr(_session);
            _generator = _load != null ? _load : GetComponentInChildren<LoadGenerator>(true);
            _measures = _renderTime != null ? _renderTime : _source != null ? _source.GetComponentInChildren<RenderTimeSource>() : null;
            if (!isActiveAndEnabled) Fail(ComponentMessages.SweepDisabled);
            else if (_source == null) Fail(ComponentMessages.NoSession);
            else if (_generator == null) Fail(ComponentMessages.NoLoadGenerator);
            else if (_measures == null) Fail(ComponentMessages.NoRenderTimeSource);
            else Begin();
        }

        /// <summary>Ends the sweep without a verdict. Still writes the rows that are already logged.</summary>
        public void StopSweep()
        {
            if (!IsRunning) return;
            End();
            ShowText(LoadSweepMessages.Stopped);
            ConsoleLog.Info(this, LoadSweepMessages.StoppedWithLog(Path));
        }

        void OnEnable()
        {
            if (_startOnEnable) StartSweep();
        }

        void OnDisable()
        {
            StopSweep();
            EndEvaluation();
        }

        void EndEvaluation()
        {
            if (_judging == null) return;
            _judging = null;
            ShowText(LoadSweepMessages.Stopped);
        }

        void Update()
        {
            // Checked here and not only in StartSweep, because Unity may enable the load generator after the sweep, and both may be destroyed.
            if (IsRunning && ProblemOfParts() is string problem) Abandon(problem);
            else if (IsRunning) Follow();
            else if (_judging != null && _judging.IsCompleted) Conclude();
        }

        void Begin()
        {
            try
            {
                _plan = new SweepPlan(_maxVertices, _steps, _secondsPerLoad, _settleSeconds, _goesDown);
                Path = SweepFile.NewPath(System.IO.Path.Combine(Application.persistentDataPath, _folder), DateTime.UtcNow);
            }
            catch (Exception fault) when (fault is InputException || fault is ArgumentException)
            {
                Fail(fault.Message);
                return;
            }
            _conditions = Conditions;
            _displayHz = _conditions.DisplayHz ?? double.NaN;
            _file = new SweepFile(Path, (int)((_plan.TimePerLoad.TotalSeconds + SecondsToBuild) * MaxHz), _conditions);
            _run = new SweepRun(_plan);
            _verticesBefore = _generator.Vertices;
            _generator.Vertices = _run.Vertices;
            _frame = null;
            _logged = (-1, 0);
            _source.Shown += Keep;
            ConsoleLog.Info(this, LoadSweepMessages.Begun(_plan, Path));
        }

        // The session's conditions, completed with the conditions of the device. They are read again, because the session may have read them before
        // the display reported its rate.
        DisplayConditions Conditions
        {
            get
            {
                var session = _source.Session?.Conditions ?? DisplayConditions.Unknown;
                return new DisplayConditions(rewritesBeforeRender: session.RewritesBeforeRender, reprojection: session.Reprojection)
                    .Or(ThisDevice.Conditions);
            }
        }

        // Called twice for a frame that is computed again before rendering. The second call replaces the data of the first.
        void Keep(DisplayFrame frame) => _frame = new SweepFrame(_source, frame, _run, _generator, _measures);

        // Logs the previous frame, because the code of a frame may change until the frame is rendered.
        void Follow()
        {
            // Also logs frames while a load is being built. The codes repeat after a period, so a picture of a frame that is missing from the
            // log could be matched to a frame one period later.
            if (_frame?.Control != null) _file.Add(_frame.Value.ToRow(_conditions.Device, _displayHz));
            ShowPhase();
            var isOver = _run.Advance(_frame?.Start ?? default, _frame?.IsReady ?? false);
            _frame = null;
            if (_file.Problem != null) Abandon(_file.Problem);
            else if (isOver) NextLoad();
        }

        void NextLoad()
        {
            if (_run.IsDone)
            {
                _judging = End();
                ShowText(LoadSweepMessages.Judging);
                return;
            }
            _file.EndLoad();
            var now = Conditions;
            var changes = _conditions.MismatchesWith(now);
            if (changes.Count > 0)
            {
                Abandon(LoadSweepMessages.Changed(changes[0]));
                return;
            }
            // The display reports its rate only some frames after the start of the scene.
            if (double.IsNaN(_displayHz)) _displayHz = now.DisplayHz ?? double.NaN;
            _generator.Vertices = _run.Vertices;
        }

        // Returns the reason why the load can be neither built nor shown; null if it can. Without this check, the sweep would wait for it forever.
        string ProblemOfParts()
        {
            if (_source == null) return LoadSweepMessages.Destroyed(name, "session");
            if (_generator == null) return LoadSweepMessages.Destroyed(name, "load generator");
            if (_generator.Problem != null) return _generator.Problem;
            return _generator.isActiveAndEnabled ? null : LoadSweepMessages.GeneratorOff(_generator.name);
        }

        void Abandon(string problem)
        {
            End();
            Problem = problem;
            ShowText(LoadSweepMessages.Stopped);
            ConsoleLog.Warn(this, problem);
        }

        Task<LoadSensitivity> End()
        {
            _source.Shown -= Keep;
            _run = null;
            // When the scene is unloaded, the generator may already be destroyed.
            if (_generator != null) _generator.Vertices = _verticesBefore;
            return _closing = _file.CloseAsync();
        }

        void Conclude()
        {
            Verdict = _judging.Result;
            _judging = null;
            Problem = _file.Problem;
            if (Verdict == null)
            {
                ShowText(LoadSweepMessages.Stopped);
                ConsoleLog.Warn(this, Problem);
                return;
            }
            var message = LoadSweepMessages.Done(Verdict.Words, Path);
            if (Verdict.Sight == LoadSight.Seen) ConsoleLog.Info(this, message);
            else ConsoleLog.Warn(this, message);
            ShowText(Verdict.Words);
            _onDone.Raise(this);
        }

        void ShowPhase()
        {
            var phase = !(_frame is SweepFrame frame) || !frame.Control.HasValue ? 1 : frame.IsShown ? 3 : 2;
            if (_logged == (_run.Index, phase)) return;
            _logged = (_run.Index, phase);
            ShowText(phase == 1 ? LoadSweepMessages.WaitingForClock : phase == 2 ? LoadSweepMessages.Building(_run.Vertices) : LoadSweepMessages.Showing(_run, _plan));
        }

        void ShowText(string words)
        {
            Words = words;
            if (_text != null) _text.text = words;
            _progressed.Raise(this);
        }

        void Fail(string what)
        {
            Problem = "load sweep '" + name + "' " + what;
            ConsoleLog.Fail(this, Problem);
        }
    }
}
