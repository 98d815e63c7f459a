using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Network;
using Nowpose.Pairing;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity
{
    /// <summary>Sets a session up by codes that the wearer looks at: the robot's marker, and once the code that the gateway shows.</summary>
    /// <remarks>
    /// Reads what the marker sources on the session's object or below it see. Before a gateway is contacted that the wearer did not agree
    /// to, it asks. What was agreed to, and the token of this headset, are kept on the device.
    /// </remarks>
    [AddComponentMenu("Nowpose/Cell Pairing")]
    [DisallowMultipleComponent]
    public sealed class CellPairing : MonoBehaviour
    {
        [SerializeField, Tooltip("The session that is set up. Empty: the one on this object or above.")]
        MrilSession _session = null;

        [SerializeField, Tooltip("Is given the cell's markers. Empty: the first one on the session's object or below.")]
        BaseAnchor _anchor = null;

        [SerializeField, Tooltip("The gateway lists this headset under it, and its diagnostics carry it, up to 64 characters. Empty: the name that "
            + "the device has in its system settings.")]
        string _headsetName = "";

        [SerializeField, Tooltip("File below the application's persistent data path in which paired cells are kept, with the tokens; or a full "
            + "path.")]
        string _fileName = "paired-cells.json";

        [SerializeField, Tooltip("There is a question: show it, and call Accept or Refuse.")]
        UnityEvent _onAsked = new UnityEvent();

        [SerializeField, Tooltip("The gateway gave this headset a token; the session connects.")]
        UnityEvent _onPaired = new UnityEvent();

        [SerializeField, Tooltip("Something went wrong; the words say what.")]
        UnityEvent _onProblem = new UnityEvent();

        readonly AppliedCell _applied = new AppliedCell();
        readonly CodesInView _view = new CodesInView();
        MrilSession _source;
        BaseAnchor _target;
        string _fileProblem, _name, _path;
        bool _isApplied;

        /// <summary>Question, words, problem or cell are others than before.</summary>
        public event Action Changed;

        /// <summary>What the wearer has to answer, in one line; null when nothing is asked.</summary>
        public string Question => Flow?.Question;

        /// <summary>Where things stand, in one line for a panel; the question while there is one.</summary>
        public string Words => Question ?? _fileProblem ?? Flow?.Words ?? "";

        /// <summary>What went wrong, in one line; null when nothing did.</summary>
        public string Problem => _fileProblem ?? Flow?.Problem;

        /// <summary>What the wearer has to answer or to do, or waits for, before the session can connect, in one line; null for nothing.</summary>
        /// <remarks>None, either, while a session is connected by its settings and no cell was paired.</remarks>
        public string Guidance => Flow == null || Flow.IsSettled || (Question == null && Cell == null && _source.IsConnecting) ? null : Flow.Words;

        /// <summary><see cref="Problem"/> without that of the file, which keeps nobody from connecting.</summary>
        internal string Obstacle => Flow?.Problem;

        /// <summary>Name of the cell in use; null for none.</summary>
        public string Cell => Flow?.Cells.Used?.Cell;

        /// <summary>Agrees to the question. Does nothing when nothing is asked.</summary>
        public void Accept() => Flow?.Accept();

        /// <summary>Declines the question; a gateway until the application starts anew or <see cref="AskToForget"/>.</summary>
        public void Refuse() => Flow?.Refuse();

        /// <summary>Asks whether to forget the cell in use: a <see cref="Question"/> like any other.</summary>
        /// <remarks>What was declined is asked again at the next look, whatever the answer.</remarks>
        public void AskToForget() => Flow?.AskToForget();

        /// <summary>Leaves the cell in use and forgets it without a question, with its token; the next look at a marker asks anew.</summary>
        public void Forget() => Flow?.Forget();

        /// <summary>Takes a text as though a marker in view held it: typed, scanned or handed over. White space around it is ignored.</summary>
        public void ReadCode(string text)
        {
            if (_source != null) Flow?.See(text?.Trim(), _source.HeadsetClock.Now);
        }

        // Null while disabled, and where there is no session.
        PairingFlow Flow { get; set; }

        void OnEnable()
        {
            _source = this.SessionOr(_session);
            if (_source == null)
            {
                ConsoleLog.Warn(this, "cell pairing '" + name + "' has no session above it to set up; assign one");
                return;
            }
            _target = _anchor != null ? _anchor : _source.GetComponentInChildren<BaseAnchor>(true);
            _name = HeadsetName.Of(_headsetName);
            _path = Path.Combine(Application.persistentDataPath, _fileName);
            Flow = new PairingFlow(PairedCellsFile.Load(_path, out _fileProblem), _name, SendInBackground);
            if (_fileProblem != null) ConsoleLog.Warn(this, _fileProblem);
        }

        void OnDisable()
        {
            Flow?.Dispose();
            Flow = null;
        }

        // Before the session computes its frame.
        void Update()
        {
            if (Flow == null || _source == null) return;
            var now = _source.HeadsetClock.Now;
            _view.Show(_source, Flow, now);
            Flow.IsTokenRefused = IsTokenRefused(_source);
            var changes = Flow.Tick(now);
            // Before anybody hears of it: whoever listens to anchor or session may throw, or disable this.
            if ((changes & PairingChange.Kept) != 0) Keep();
            try
            {
                Apply((changes & PairingChange.Applied) != 0);
            }
            finally
            {
                if (changes != PairingChange.None && Flow != null) Tell(changes);
            }
        }

        void Apply(bool isNew)
        {
            var used = Flow.Cells.Used;
            if (isNew)
            {
                _isApplied = false;
                _applied.Place(_target, used);
            }
            if (!_isApplied) _isApplied = _applied.Connect(_source, used, _name);
        }

        void Tell(PairingChange changes)
        {
            if ((changes & PairingChange.Problem) != 0) ConsoleLog.Warn(this, Flow.Problem ?? _fileProblem);
            if ((changes & PairingChange.Paired) != 0) ConsoleLog.Say(this, Flow.Words);
            // Whoever hears of it may disable this.
            Changed?.Invoke();
            if ((changes & PairingChange.Asked) != 0) _onAsked.Invoke();
            if ((changes & PairingChange.Paired) != 0) _onPaired.Invoke();
            if ((changes & PairingChange.Problem) != 0) _onProblem.Invoke();
        }

        void Keep()
        {
            try
            {
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
