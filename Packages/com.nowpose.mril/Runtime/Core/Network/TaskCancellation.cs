using System;
using System.Threading;
using System.Threading.Tasks;

namespace Nowpose.Network
{
    /// <summary>Cancels the waiting for what cannot be cancelled itself, such as looking up a name.</summary>
    static class TaskCancellation
    {
        /// <exception cref="OperationCanceledException">Cancelled first; what becomes of the task is nobody's concern any more.</exception>
        public static async Task OrCancelled(this Task task, CancellationToken cancel)
        {
            var cancelled = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
            using (cancel.Register(() => cancelled.TrySetResult(true)))
                await Task.WhenAny(task, cancelled.Task).ConfigureAwait(false);
            if (!task.IsCompleted)
            {
                // Looked at, so that a failure nobody waits for is not reported as forgotten.
                _ = task.ContinueWith(late => late.Exception, CancellationToken.None, TaskContinuationOptions.OnlyOnFaulted, TaskScheduler.Default);
                throw new OperationCanceledException(cancel);
            }
            await task.ConfigureAwait(false);
        }

        /// <inheritdoc cref="OrCancelled(Task, CancellationToken)"/>
        public static async Task<T> OrCancelled<T>(this Task<T> task, CancellationToken cancel)
        {
            await OrCancelled((Task)task, cancel).ConfigureAwait(false);
            return await task.ConfigureAwait(false);
        }
    }
}
