using System.Linq;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Status;

namespace Nowpose.Tests.Unity.Status
{
    /// <summary>Creates statistics with given values, and returns the rows that the status panel shows for them.</summary>
    static class StatusRows
    {
        public static readonly SessionSettings Loopback = new SessionSettings(new ConnectionSettings("127.0.0.1"), default);

        public static SessionStatistics Statistics(long samples, params JointStatus[] joints)
        {
            var statistics = new SessionStatistics { Samples = samples };
            statistics.OwnRobot.JointStatuses.AddRange(joints);
            return statistics;
        }

        /// <summary>A message of this many words; null for none.</summary>
        public static string Words(int count) => count == 0 ? null : string.Join(" ", Enumerable.Repeat("word", count));

        /// <summary>Returns the value and the note of a row, separated by a vertical bar.</summary>
        /// <param name="statistics">Statistics to show; null for the statistics of a new session.</param>
        public static string Row(StatusRow row, SessionStatistics statistics = null, SessionSettings settings = null, string robot = null)
        {
            var texts = new StatusTexts();
            texts.Update(statistics ?? new SessionStatistics(), settings ?? Loopback, robot, null);
            return texts.ValueOf(row) + "|" + texts.NoteOf(row);
        }
    }
}
