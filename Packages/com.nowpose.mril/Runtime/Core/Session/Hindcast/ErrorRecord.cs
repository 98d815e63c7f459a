namespace Nowpose.Session.Hindcast
{
    /// <summary>Errors of one quantity over the last ten seconds and over the whole run.</summary>
    sealed class ErrorRecord
    {
        readonly ErrorWindow _window = new ErrorWindow();
        readonly ErrorRun _run = new ErrorRun();

        /// <param name="isOfRun">False for a frame that was shown before the run started.</param>
        /// <returns>Whether the errors are plausible. If not, they are ignored.</returns>
        public bool Add(ControlTime at, in ErrorSums frame, bool isOfRun)
        {
            if (!frame.IsPlausible) return false;
            _window.Add(at, frame);
            if (isOfRun) _run.Add(frame);
            return true;
        }

        /// <summary>Returns the errors of the last ten seconds; null while unknown.</summary>
        public DisplayedError? Now(ControlTime now) => _window.Read(now);

        /// <summary>Errors since <see cref="RestartRun"/>; null while unknown.</summary>
        public DisplayedError? OfRun => _run.Read();

        public void ResetWindow() => _window.Reset();

        public void RestartRun() => _run.Reset();
    }
}
