using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Messages;
using Nowpose.Network;

namespace Nowpose.Pairing
{
    /// <summary>
    /// Evaluates the codes in view: asks the wearer before it contacts a new gateway, exchanges the gateway's code
    /// for the headset's own token, and selects the cell to connect to.
    /// </summary>
    /// <remarks>
    /// Use it on the frame loop's thread. In each frame, call <see cref="See"/> for the content of each code in view, and then <see cref="Tick"/>
    /// once. Allocates only if something has changed.
    /// </remarks>
    sealed class PairingFlow : IDisposable
    {
        readonly CodeExchange _exchange;
        readonly SeenCodes _seen = new SeenCodes();
        readonly OtherCell _other = new OtherCell();
        readonly HashSet<string> _refused = new HashSet<string>(StringComparer.Ordinal);
        PairingQuestion _asked;
        readonly PairingStatus _status;
        HeadsetTime _now, _quietUntil, _readAt;
        string _read;
        bool _isTokenRefused;

        /// <param name="cells">Cells accepted in earlier runs.</param>
        /// <param name="headsetName">Name of this headset in the gateway's list.</param>
        /// <param name="send">Exchanges a token without blocking, such as <see cref="PairingRequest.SendAsync"/> on another thread.</param>
        public PairingFlow(
            PairedCells cells, string headsetName, Func<ConnectionSettings, string, CancellationToken, Task<PairingAnswer>> send)
        {
            Cells = cells;
            _exchange = new CodeExchange(headsetName, send);
            _status = new PairingStatus(() => Question, () => PairingMessages.Calm(_exchange.Cell, Cells.Used, _isTokenRefused));
            if (cells.Used != null) _status.Change(PairingChange.Applied);
        }

        public PairedCells Cells { get; private set; }

        /// <summary>The question to the wearer; null if there is none.</summary>
        public string Question => _asked?.Text;

        /// <summary>The problem in one line; null if there is none.</summary>
        public string Problem => _status.Problem;

        /// <summary>Status of the pairing in one line, for a panel.</summary>
        public string Words => _status.Words;

        /// <summary>Whether the gateway rejects the token of the cell in use, so that a new code is needed.</summary>
        public bool IsTokenRefused
        {
            set
            {
                if (value == _isTokenRefused) return;
                _isTokenRefused = value;
                _status.Change(PairingChange.Words);
            }
        }

        /// <summary>Whether a connection is possible without any action by the wearer or the gateway.</summary>
        public bool IsSettled => _asked == null && _exchange.Cell == null && !_isTokenRefused && Cells.Used?.IsReady == true;

        /// <summary>Reads the text of a code in view, which may come from any source.</summary>
        public void See(string text, HeadsetTime now)
        {
            var seen = _seen.Read(text, _now = now, out var fault);
            if (fault != null) FailTemporarily(fault);
            if (seen?.Cell != null) SeeCell(seen);
            else if (seen?.Token != null) SeeToken(seen.Token, now);
        }

        /// <summary>
        /// Reads the text of a code that was typed or scanned elsewhere. It offers a paired cell at once, asks about a declined gateway again, and reports an
        /// invalid text again. A reader may repeat the text of a code that stays in view.
        /// </summary>
        public void Read(string text, HeadsetTime now)
        {
            var isRepeated = text == _read && now - _readAt < PairingLimits.SameReading;
            (_now, _read, _readAt) = (now, text, now);
            if (!isRepeated) Decide(text);
            See(text, now);
        }

        void Decide(string text)
        {
            _seen.Forget(text);
            var seen = _seen.Read(text, _now, out var fault);
            if (seen == null || fault != null) FailTemporarily(fault ?? PairingCodeMessages.NotACode);
            else if (seen.Cell != null && _asked?.Forgotten == null)
            {
                _refused.Remove(seen.Gateway);
                _asked = null;
                _status.Change(PairingChange.Words);
                if (Known(seen.Cell) is PairedCell other && other.Cell != Cells.Used?.Cell) SwitchTo(other);
            }
        }

        /// <summary>Processes the codes seen; called once a frame.</summary>
        /// <returns>Changes since the last tick.</returns>
        public PairingChange Tick(HeadsetTime now)
        {
            _now = now;
            _status.Expire(now);
            ConsiderOther(now);
            Offer(now);
            FollowExchange(now);
            return _status.TakeChanges();
        }

        /// <summary>Answers the question with yes. Does nothing if there is none.</summary>
        public void Accept()
        {
            var asked = _asked;
            if (asked == null) return;
            Answer();
            if (asked.Code != null) Connect(asked.Code.Cell);
            else if (asked.Forgotten != null) Forget(asked.Forgotten);
            else if (Cells.Find(asked.Used) is PairedCell other) Use(other);
        }

        /// <summary>Answers the question with no. A declined gateway stays declined for this run. Does nothing without a question.</summary>
        public void Refuse()
        {
            if (_asked == null) return;
            if (_asked.Code != null) _refused.Add(_asked.Code.Gateway);
            if (_asked.Used != null) _other.Decline(_asked.Used, _now);
            Answer();
        }

        /// <summary>
        /// Asks whether to forget the cell in use, in place of any other question. Also clears the declined gateways and cells, regardless of
        /// the answer, so that the next marker in view asks again. If no cell is in use, this is the only effect.
        /// </summary>
        public void AskToForget()
        {
            Reconsider();
            if (Cells.Used != null) Ask(PairingQuestion.Forget(Cells.Used));
        }

        /// <summary>
        /// Removes the cell in use and its token, and clears the declined gateways and cells, so that the next marker in view asks again.
        /// </summary>
        public void Forget()
        {
            Reconsider();
            Answer();
            Forget(Cells.Used?.Cell);
        }

        public void Dispose() => _exchange.Dispose();

        void SeeCell(SeenCode seen)
        {
            if (Known(seen.Cell) is PairedCell known)
            {
                if (!known.Holds(seen.Cell)) Add(seen, known);
                _other.See(known.Cell, known.Cell == Cells.Used?.Cell);
            }
            else if (MayAsk && !_refused.Contains(seen.Gateway)) Ask(PairingQuestion.Connect(seen, Cells.Find(seen.Cell.Cell)));
        }

        // The paired cell of a code; null if there is none, or if it has another gateway.
        PairedCell Known(CellCode code) => Cells.Find(code.Cell) is PairedCell known && known.Newest.HasSameGateway(code) ? known : null;

        bool MayAsk => _asked == null && _now >= _quietUntil;

        // Asks first, because otherwise a wearer who walks past another robot would change the source of the samples.
        void ConsiderOther(HeadsetTime now)
        {
            var name = _other.Wanted(now);
            if (name != null && MayAsk && Cells.Find(name) is PairedCell other) SwitchTo(other);
        }

        void SwitchTo(PairedCell other)
        {
            if (Cells.Used == null) Use(other);
            else Ask(PairingQuestion.Use(other, Cells.Used));
        }

        void Reconsider()
        {
            _refused.Clear();
            _read = null;
            _other.Reconsider();
        }

        void Add(SeenCode seen, PairedCell known)
        {
            if (!known.IsFull)
            {
                Store(known.With(seen.Cell));
                return;
            }
            if (!seen.IsTooManyReported) FailTemporarily(PairingMessages.TooMany(known.Cell));
            seen.IsTooManyReported = true;
        }

        void Store(PairedCell cell)
        {
            var used = Cells.Used;
            Cells = Cells.Use(cell);
            // A new marker of another robot does not change the robot in use.
            if (used != null && used.Cell != cell.Cell) Cells = Cells.Use(used);
            _status.Change(PairingChange.Applied | PairingChange.Kept);
        }

        void Ask(PairingQuestion question)
        {
            if (_asked?.Text == question.Text) return;
            _asked = question;
            _status.Change(PairingChange.Asked);
        }

        void Connect(CellCode code)
        {
            var known = Cells.Find(code.Cell);
            // The running exchange is with the previous gateway of this cell, whose token is not valid for the new gateway.
            if (_exchange.Cell == code.Cell) _exchange.End();
            // The same key means the same gateway, so the headset's token stays valid.
            var token = known != null && Equals(known.Newest.Pin, code.Pin) ? known.Token : null;
            Use(new PairedCell(new[] { code }, token));
        }

        void Forget(string cell)
        {
            _exchange.End();
            if (cell != null) Cells = Cells.Without(cell);
            _status.Change(cell == null ? PairingChange.Words : PairingChange.Applied | PairingChange.Kept);
        }

        void Answer()
        {
            if (_asked != null) _quietUntil = _now + PairingLimits.QuestionPause;
            _asked = null;
            _status.ClearProblem();
            _status.Change(PairingChange.Words);
        }

        void Use(PairedCell cell)
        {
            Cells = Cells.Use(cell);
            _status.Change(PairingChange.Applied | PairingChange.Kept);
        }

        void SeeToken(TokenCode code, HeadsetTime now)
        {
            if (_exchange.Cell != null) return;
            if (_exchange.WasTried(code))
            {
                if (Cells.UsedNeeds(code, _isTokenRefused) && Problem == null && Question == null) _status.SetWords(PairingMessages.CodeWasTried);
                return;
            }
            _exchange.Wait(code, now);
            if (Cells.HasGatewayOf(code)) return;
            if (Words != PairingMessages.MarkerFirst && Question == null) _status.SetWords(PairingMessages.MarkerFirst);
        }

        // The wearer may look at the marker and the code in either order.
        void Offer(HeadsetTime now)
        {
            if (_exchange.Waiting == null || _exchange.Cell != null || !_exchange.Offer(Cells.TakerOf(_exchange.Waiting, _isTokenRefused), now)) return;
            _status.ClearProblem();
            _status.Change(PairingChange.Words);
        }

        void FollowExchange(HeadsetTime now)
        {
            if (_exchange.Cell == null) return;
            var before = _exchange.Trouble;
            var answer = _exchange.Follow(now);
            if (answer == null)
            {
                if (_exchange.Trouble != before) _status.Fail(_exchange.Trouble);
                return;
            }
            var cell = Cells.Find(_exchange.Cell);
            _exchange.End();
            if (answer.Token == null) _status.Fail(answer.Problem);
            else if (cell != null) Take(cell, answer.Token);
        }

        void Take(PairedCell cell, string token)
        {
            _status.ClearProblem();
            if (cell.Cell == Cells.Used?.Cell) IsTokenRefused = false;
            Store(cell.WithToken(token));
            _status.Change(PairingChange.Paired);
            // A gateway's token is valid for all its cells.
            foreach (var other in Cells.All)
                if (other.Token == null && other.Newest.HasSameGateway(cell.Newest)) Store(other.WithToken(token));
            _status.SetWords(PairingMessages.Paired(cell.Cell));
        }

        void FailTemporarily(string problem) => _status.Fail(problem, _now + PairingLimits.FaultShown);
    }
}
