using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Reason why a session could not start, and the time of the next attempt. The default has no reason.</summary>
    struct StartProblem
    {
        const double RetrySeconds = 1;

        double _nextAttempt;

        /// <summary>The reason in one line; null if there is no problem.</summary>
        public string Text { get; private set; }

        /// <summary>Whether the session failed to start, and should try again now.</summary>
        public bool IsDue => Text != null && Time.unscaledTimeAsDouble >= _nextAttempt;

        /// <summary>Stores the reason after an attempt, and logs it if it is not the reason of the previous attempt.</summary>
        public void Report(string reason, SessionLog log)
        {
            if (reason != Text) log.Fail(reason);
            Text = reason;
            _nextAttempt = Time.unscaledTimeAsDouble + RetrySeconds;
        }
    }
}
