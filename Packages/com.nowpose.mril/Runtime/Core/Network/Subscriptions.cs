using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Topics to which a client subscribes after connecting, and at once if they are added later. Thread-safe.</summary>
    sealed class Subscriptions
    {
        readonly List<(string Topic, string Type)> _topics = new List<(string, string)>();
        TaskCompletionSource<bool> _added = NewSource();

        /// <summary>Adds a topic. Does nothing if it was added before.</summary>
        /// <param name="type">The type's name, such as <see cref="RosTopics.JointStateType"/>.</param>
        public void Add(string topic, string type)
        {
            TaskCompletionSource<bool> added;
            lock (_topics)
            {
                if (_topics.Contains((topic, type))) return;
                _topics.Add((topic, type));
                added = _added;
                _added = NewSource();
            }
            added.SetResult(true);
        }

        /// <summary>Adds the topics of a robot, and the topics of the gateway's joint status and version.</summary>
        /// <param name="robot">The robot's namespace; empty for the robot without a namespace.</param>
        public void AddRobot(string robot)
        {
            Add(RobotTopic.NameOf(robot, RosTopics.JointStates), RosTopics.JointStateType);
            Add(RobotTopic.NameOf(robot, RosTopics.JointTrajectory), RosTopics.JointTrajectoryType);
            Add(RobotTopic.NameOf(robot, RosTopics.RobotDescription), RosTopics.StringType);
            Add(RosTopics.JointStatus, RosTopics.DiagnosticsType);
            Add(RosTopics.Version, RosTopics.StringType);
        }

        /// <summary>Returns the topic with an index in the order of addition; waits until it has been added.</summary>
        public async Task<(string Topic, string Type)> At(int index, CancellationToken cancel)
        {
            while (true)
            {
                Task added;
                lock (_topics)
                {
                    if (index < _topics.Count) return _topics[index];
                    added = _added.Task;
                }
                await Task.WhenAny(added, Task.Delay(Timeout.Infinite, cancel)).ConfigureAwait(false);
                cancel.ThrowIfCancellationRequested();
            }
        }

        // Continuations must not run on the thread that adds a topic, because it is the frame loop's thread.
        static TaskCompletionSource<bool> NewSource() => new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
    }
}
