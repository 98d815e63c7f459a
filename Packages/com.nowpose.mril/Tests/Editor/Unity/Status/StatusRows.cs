using System.Reflection;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Status;

namespace Nowpose.Tests.Unity.Status
{
    /// <summary>Statistics with given values, and the rows that the status panel shows of them.</summary>
    static class StatusRows
    {
        public static readonly SessionSettings Loopback = new SessionSettings(new ConnectionSettings("127.0.0.1"), default);

        const BindingFlags Declared = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

        // Uses reflection, because only the session can set these properties.
        public static SessionStatistics Statistics(params (string Property, object Value)[] values)
        {
            var statistics = new SessionStatistics();
            foreach (var (property, value) in values) typeof(SessionStatistics).GetProperty(property, Declared).SetValue(statistics, value);
            return statistics;
        }

        public static SessionStatistics Statistics(long samples, params JointStatus[] joints)
        {
            var statistics = Statistics(("Samples", samples));
            statistics.ChangeableJointStatuses.AddRange(joints);
            return statistics;
        }

        /// <summary>Returns value and note of a row, separated by a bar.</summary>
        public static string Row(StatusRow row, SessionStatistics statistics, SessionSettings settings = null, string robot = null)
        {
            var texts = new StatusTexts();
            texts.Update(statistics, settings ?? Loopback, robot, null);
            return texts.ValueOf(row) + "|" + texts.NoteOf(row);
        }

        public static string Row(StatusRow row, params (string Property, object Value)[] values) => Row(row, Statistics(values));
    }
}
