using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Pairing;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity
{
    /// <summary>
    /// Sets up a session by means of codes that the wearer looks at: the marker at the robot and, for the first pairing, the code that the gateway
    /// shows.
    /// </summary>
    /// <remarks>
    /// Reads the marker sources on the session's object and its children. Asks the wearer before it contacts a new gateway. Saves accepted cells
    /// and the tokens of this headset on the device.
    /// </remarks>
    [AddComponentMenu("Nowpose/Cell Pairing")]
    [DisallowMultipleComponent]
    public sealed class CellPairing : MonoBehaviour
    {
        [SerializeField, Tooltip("The session to set up. Empty: the session on this object or a parent.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("The anchor that receives the cell's markers. Empty: the first anchor on the session's object or a child.")]
        BaseAnchor _anchor = null;

        [SerializeField, Tooltip("Name of this headset in the gateway's list and in the diagnostics, up to 64 characters. Empty: the device's "
            + "name in its system settings; on Android with four hexadecimal digits.")]
        string _headsetName = "";

        [SerializeField, Tooltip("File for the paired cells and their tokens: a path below the application's persistent data path, or a full "
            + "path.")]
        string _fileName = "paired-cells.json";

        [SerializeField, Tooltip("Called when there is a question. Show it, and call Accept or Refuse.")]
        UnityEvent _onAsked = new UnityEvent();

        [SerializeField, Tooltip("Called with the text of a question when it appears or changes, and with an empty string when it ends.")]
        UnityEvent<string> _onQuestion = new UnityEvent<string>();

        [SerializeField, Tooltip("Called when the gateway has given this headset a token. The session then connects.")]
        UnityEvent _onPaired = new UnityEvent();

        [SerializeField, Tooltip("Called when a problem has occurred. The property Words states it.")]
        UnityEvent _onProblem = new UnityEvent();

        // The enabled pairings of all scenes that may save: at most one for each file. Each removes itself, also when play mode ends, so the list is
        // correct without a domain reload.
        static readonly List<CellPairing> Savers = new List<CellPairing>();

        readonly AppliedCell _applied = new AppliedCell();
        readonly CodesInView _view = new CodesInView();
        readonly Listeners<Action> _changed = new Listeners<Action>();
        MrilSession _source;
        BaseAnchor _target;
        [NonSerialized] string _fileProblem, _unsaved, _name, _path, _shown = "";
        [NonSerialized] bool _isApplied, _isCallLogged;

        /// <summary>Raised when <see cref="Question"/>, <see cref="Words"/>, <see cref="Problem"/> or <see cref="Cell"/> has changed.</summary>
        public event Action Changed { add => _changed.Add(value); remove => _changed.Remove(value); }

        /// <summary>The open question to the wearer, in one line; null if there is none.</summary>
        public string Question => Flow?.Question;

        /// <summary>Status in one line for a panel. While a question is open, this is the question.</summary>
        public string Words => Question ?? _fileProblem ?? Flow?.Words ?? "";

        /// <summary>The problem in one line; null if there is none.</summary>
        public string Problem => _fileProblem ?? Flow?.Problem;

        /// <summary>
        /// Next step that the wearer or the gateway must take before the session can connect, in one line; null if no step is necessary.
        /// </summary>
        /// <remarks>Also null while no cell is paired and the session connects with its own settings.</remarks>
        public string Guidance => Flow == null || Flow.IsSettled || (Question == null && Cell == null && _source.IsConnecting) ? null : Flow.Words;

        /// <summary>
        /// Like <see cref="Problem"/>, but excludes problems with the file of paired cells, because these do not prevent a connection.
        /// </summary>
        internal string Obstacle => Flow?.Problem;

        /// <summary>Name of the cell in use; null if no cell is paired.</summary>
        public string Cell => Flow?.Cells.Used?.Cell;

        /// <summary>Answers the open question with yes. Does nothing if no question is open.</summary>
        public void Accept() => FlowForCall()?.Accept();

        /// <summary>
        /// Answers the open question with no. A declined gateway stays declined until the application restarts, or until <see cref="AskToForget"/> or
        /// <see cref="ReadCode"/> is called.
        /// </summary>
        public void Refuse() => FlowForCall()?.Refuse();

        /// <summary>Opens a <see cref="Question"/> that asks whether to forget the cell in use.</summary>
        /// <remarks>After either answer, the pairing asks again about declined gateways and cells when their markers come into view.</remarks>
        public void AskToForget() => FlowForCall()?.AskToForget();

        /// <summary>Deletes the cell in use and its token without asking the wearer. When a marker comes into view, the pairing asks again.</summary>
        public void Forget() => FlowForCall()?.Forget();

        /// <summary>
        /// Processes the text of a code that was typed or scanned elsewhere: offers a paired cell at once, and reports each invalid text. A reader of codes may
        /// repeat the text while the code is in view. Ignores white space around it.
        /// </summary>
        public void ReadCode(string text)
        {
            if (FlowForCall() is PairingFlow flow && _source != null) flow.Read(text?.Trim() ?? "", _source.HeadsetClock.Now);
        }

        // Returns the flow for a method that a script or an event has called. The first call while this component is disabled is logged, because it has
        // no effect.
        PairingFlow FlowForCall()
        {
            if (Flow != null || isActiveAndEnabled || _isCallLogged) return Flow;
            _isCallLogged = true;
            ConsoleLog.Warn(this, ComponentMessages.Of("cell pairing", name, ComponentMessages.PairingDisabled));
            return null;
        }

        // Null while this component is disabled or has no session.
        PairingFlow Flow { get; set; }

        void OnEnable()
        {
            _source = this.RequiredSession(_session, "cell pairing");
            if (_source == null) return;
            _target = _anchor != null ? _anchor : _source.GetComponentInChildren<BaseAnchor>(true);
            _name = HeadsetName.Of(_headsetName);
            _path = Path.Combine(Application.persistentDataPath, _fileName);
            Flow = new PairingFlow(PairedCellsFile.Load(_path, out _fileProblem, out var isUnread), _name, SendInBackground);
            // If another pairing saves the file, this list becomes out of date and is never saved. Enabling this pairing again reads the file again.
            var saver = Savers.Find(each => each._path == _path);
            _unsaved = isUnread ? _fileProblem : saver != null ? PairedCellMessages.Shared(_path, saver.name) : null;
            if (_unsaved == null) Savers.Add(this);
            if (_fileProblem != null) ConsoleLog.Warn(this, _fileProblem);
        }

        void OnDisable()
        {
            Savers.Remove(this);
            Flow?.Dispose();
            Flow = null;
            _isCallLogged = false;
            ShowQuestion();
        }

        // Runs before the session computes its frame in LateUpdate.
        void Update()
        {
            if (Flow == null || _source == null) return;
            var now = _source.HeadsetClock.Now;
            _view.Show(_source, Flow, now);
            Flow.IsTokenRefused = IsTokenRefused(_source);
            var changes = Flow.Tick(now);
            // Saves before the events: a listener of the anchor or the session may disable this component.
            if ((changes & PairingChange.Kept) != 0) Keep();
            Apply((changes & PairingChange.Applied) != 0);
            if (changes != PairingChange.None && Flow != null) Notify(changes);
        }

        void Apply(bool isNew)
        {
            var (used, session) = (Flow.Cells.Used, _source.Session);
            _isApplied &= !isNew;
            var isOtherBase = isNew && _applied.Place(_target, used);
            if (!_isApplied) _isApplied = _applied.Connect(_source, used, _name);
            if (isOtherBase && _source.Session == session) _source.Restart();
        }

        void Notify(PairingChange changes)
        {
            if ((changes & PairingChange.Problem) != 0) ConsoleLog.Warn(this, Flow.Problem ?? _fileProblem);
            if ((changes & PairingChange.Paired) != 0) ConsoleLog.Info(this, Flow.Words);
            // A listener may disable this component.
            _changed.Raise(this);
            ShowQuestion();
            if ((changes & PairingChange.Asked) != 0) _onAsked.Raise(this);
            if ((changes & PairingChange.Paired) != 0) _onPaired.Raise(this);
            if ((changes & PairingChange.Problem) != 0) _onProblem.Raise(this);
        }

        void ShowQuestion()
        {
            var question = Question ?? "";
            if (question == _shown) return;
            _shown = question;
            _onQuestion.Raise(this, question);
        }

        void Keep()
        {
            try
            {
                if (_unsaved != null) throw new InputException(_unsaved);
                PairedCellsFile.Save(_path, Flow.Cells);
                _fileProblem = null;
            }
            catch (InputException fault)
            {
                if (_fileProblem != fault.Message) ConsoleLog.Warn(this, fault.Message);
                _fileProblem = fault.Message;
            }
        }

        static Task<PairingAnswer> SendInBackground(ConnectionSettings gateway, string token, CancellationToken cancel) =>
            Task.Run(() => PairingRequest.SendAsync(gateway, token, cancel), cancel);

        static bool IsTokenRefused(MrilSession session) =>
            session.Session != null && (session.Session.SampleLink.IsTokenRefused || session.Session.SyncLink.IsTokenRefused);
    }
}
